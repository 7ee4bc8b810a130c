// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/penetration.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "cases.h"
#include "convex_depth.h"
#include "exact_penetration.h"
#include "penetration_laws.h"
#include "reproduction.h"
#include "soak.h"

namespace tricover::soak {
namespace {

/// Of few vertices.
std::string wrongByBruteForce(const Case& c, const Penetration& p) {
  const double bound = (1 + 1e-9) * exact::hullDepth(c.a, c.pose_a, c.b, c.pose_b);
  const double truth = exact::penetrationDepth(c.a, c.pose_a, c.b, c.pose_b, bound);
  const double error = 1e-11 * (c.a.radius() + c.b.radius()) + 2 * support::precisionOf(c);
  return !p.optimal || std::abs(p.depth - truth) <= error ? ""
                                                          : "depth by brute force, which is " + support::hex(truth);
}

std::string wrongAnswer(Random& random, const Drawn& drawn, const std::optional<Penetration>& p) {
  const Case& c = drawn.c;
  std::string wrong = support::wrongPenetration(random, c, 0, p, 6);
  if (!wrong.empty() || !p || std::isinf(p->depth)) return wrong;
  if (random.oneIn(8)) wrong = support::wrongSwapped(c, *p);
  if (!wrong.empty()) return wrong;
  if (support::isStrictlyConvex(c.a) && support::isStrictlyConvex(c.b)) return support::wrongConvexDepth(c, p->depth);
  const bool is_small = c.a.vertexCount() * c.b.vertexCount() <= 30 && drawn.size > 1e-3 && c.a.radius() < 1e3 &&
                        c.b.radius() < 1e3 && c.pose_b.translation().norm() < 1e3;
  return is_small && random.oneIn(300) ? wrongByBruteForce(c, *p) : "";
}

/// With a margin the way leads to where they are farther apart than that, and none that is shorter does.
std::string wrongWithMargin(Random& random, const Case& c) {
  const double margin = random.unit() * std::max(c.a.radius(), c.b.radius());
  if (!std::isfinite(margin)) return "";
  const std::string wrong =
      support::wrongPenetration(random, c, margin, penetration(c.a, c.pose_a, c.b, c.pose_b, {margin}), 4);
  return wrong.empty() ? "" : wrong + " with the margin " + support::hex(margin);
}

}  // namespace

/// penetration(): its way parts them, none that is shorter is found; convex pairs against the exact depth, small ones
/// now and then against brute force.
void soakPenetration(Run& run) {
  while (run.next()) {
    Random& random = run.random();
    Limits limits;
    limits.most_exponent = 280;
    limits.most_vertices = 16;
    limits.convex = random.coin();
    const Drawn drawn = anyCase(random, limits);
    const Case& c = drawn.c;
    const auto p = penetration(c.a, c.pose_a, c.b, c.pose_b);
    run.count(drawn.family, p.has_value());
    std::string problem = wrongAnswer(random, drawn, p);
    if (problem.empty() && random.oneIn(4)) problem = wrongWithMargin(random, c);
    if (problem.empty()) continue;
    const std::string found = p ? ", depth " + support::hex(p->depth) + ", bound " + support::hex(p->lower_bound) : "";
    run.fail(drawn.family, problem + found, support::reproduction(c));
  }
}

}  // namespace tricover::soak
