// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/penetration.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "cases.h"
#include "contact_laws.h"
#include "convex_depth.h"
#include "exact_penetration.h"
#include "exact_reference.h"
#include "reference.h"
#include "reproduction.h"
#include "shapes.h"
#include "soak.h"

namespace tricover::soak {
namespace {

double length(const Vec2& v) { return std::hypot(v.x(), v.y()); }

/// How precise penetration.h says a result is.
double precision(const Case& c) {
  const double between = length(c.pose_b.translation() - c.pose_a.translation());
  return 1e-12 * std::min(c.a.radius(), c.b.radius()) + 0x1p-43 * (c.a.radius() + c.b.radius() + between) + 0x1p-1060;
}

/// What a translation's sum with a pose's is off by.
double spacing(const Case& c) {
  return 0x1p-43 * (c.pose_a.translation().lpNorm<1>() + c.pose_b.translation().lpNorm<1>());
}

bool collideAfter(const Case& c, const Vec2& way) {
  Case moved = c;
  moved.pose_b.translation() += way;
  return Reference(moved).collide();
}

/// A quarter of what the translation is longer by wouldn't do, as between edges that are nearly parallel; or not a
/// little aside, as in the tip of a slit, where rounding decides.
bool needsAll(const Case& c, const Penetration& p) {
  const Vec2 limit = p.depth * p.normal, quarter = limit + (p.translation - limit) / 4;
  const Vec2 across = Vec2(-quarter.y(), quarter.x()).stableNormalized();
  for (const double aside : {0.0, precision(c), -precision(c)}) {
    const Vec2 way = quarter + aside * across;
    Case moved = c;
    moved.pose_a.translation() -= way;
    if (collideAfter(c, way) || Reference(moved).collide()) return true;
  }
  return false;
}

std::string wrongConvex(const Case& c, const Penetration& p) {
  const Reference::Bounds bounds = convexDepth(c);
  // Of the depth, or of 1e-14 of the coordinates, which rounding(c) is an upper bound of.
  const double least = support::rounding(c);
  const auto isRight = [&](long double low, long double high) {
    const long double error = 1e-14L * std::max(low, static_cast<long double>(least));
    return p.depth <= low + error && p.depth >= high - error;
  };
  if (isRight(bounds.low, bounds.high)) return "";
  const double truth = exact::distanceBelow(exact::convexPenetrationSquared(c.a, c.pose_a, c.b, c.pose_b));
  return isRight(truth, truth) ? "" : "depth, which is " + support::hex(truth);
}

/// Of few vertices.
std::string wrongByBruteForce(const Case& c, const Penetration& p) {
  const double bound = (1 + 1e-9) * exact::hullDepth(c.a, c.pose_a, c.b, c.pose_b);
  const double truth = exact::penetrationDepth(c.a, c.pose_a, c.b, c.pose_b, bound);
  const double error = 1e-11 * (c.a.radius() + c.b.radius()) + 2 * precision(c);
  return !p.optimal || std::abs(p.depth - truth) <= error ? ""
                                                          : "depth by brute force, which is " + support::hex(truth);
}

std::string wrongWith(Random& random, const Drawn& drawn, const Penetration& p) {
  const Case& c = drawn.c;
  const double tiny = precision(c);
  // Where rounding the coordinates loses a polygon's size.
  if (std::isinf(p.depth)) return std::min(c.a.radius(), c.b.radius()) < support::rounding(c) ? "" : "no depth";
  if (!(p.depth >= 0 && p.lower_bound >= 0 && p.lower_bound <= p.depth)) return "depth or lower_bound";
  if (!(std::abs(p.normal.norm() - 1) <= 1e-12)) return "normal is no unit vector";
  if (!(length(p.translation) <= p.depth + 2 * tiny + 2 * spacing(c)) && !needsAll(c, p))
    return "translation is too long";
  if (p.optimal && !(p.depth - p.lower_bound <= tiny)) return "not optimal";
  if (!p.optimal && p.depth - p.lower_bound <= tiny / 8) return "optimal, but said not to be";
  if (collideAfter(c, p.translation)) return "translation doesn't part them";
  for (int i = 0; i < 6; ++i) {
    const double way = (i % 2 == 0 ? 0.999 : random.unit()) * p.lower_bound - tiny - spacing(c);
    if (way > 0 && !collideAfter(c, way * support::direction(random.real(0, 6.3)))) return "a shorter one parts them";
  }
  if (isStrictlyConvex(c.a) && isStrictlyConvex(c.b)) return wrongConvex(c, p);
  const bool is_small = c.a.vertexCount() * c.b.vertexCount() <= 30 && drawn.size > 1e-3 && c.a.radius() < 1e3 &&
                        c.b.radius() < 1e3 && c.pose_b.translation().norm() < 1e3;
  return is_small && random.oneIn(300) ? wrongByBruteForce(c, p) : "";
}

/// With a margin the way leads to where they are farther apart than that, and none that is shorter does.
std::string wrongWithMargin(Random& random, const Case& c) {
  const double margin = random.unit() * std::max(c.a.radius(), c.b.radius());
  if (!std::isfinite(margin)) return "";
  const bool truth = Reference(c).within(margin);
  const auto p = penetration(c.a, c.pose_a, c.b, c.pose_b, {margin});
  const std::string of = " with the margin " + support::hex(margin);
  if (p.has_value() != truth) return "a penetration, or none," + of;
  if (!p || std::isinf(p->depth)) return "";
  const auto areWithinAfter = [&](const Vec2& way) {
    Case moved = c;
    moved.pose_b.translation() += way;
    return Reference(moved).within(margin);
  };
  if (areWithinAfter(p->translation)) return "translation doesn't part them" + of;
  for (int i = 0; i < 4; ++i) {
    const double way =
        (i % 2 == 0 ? 0.999 : random.unit()) * p->lower_bound - precision(c) - 1e-12 * margin - spacing(c);
    if (way > 0 && !areWithinAfter(way * support::direction(random.real(0, 6.3))))
      return "a shorter one parts them" + of;
  }
  return "";
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
    const bool truth = Reference(c).collide();
    run.count(drawn.family, truth);
    const auto p = penetration(c.a, c.pose_a, c.b, c.pose_b);
    std::string problem;
    if (p.has_value() != truth)
      problem = "a penetration, or none";
    else if (p)
      problem = wrongWith(random, drawn, *p);
    if (problem.empty() && p && random.oneIn(8) && !support::isOneTwice(c)) {
      const auto q = penetration(c.b, c.pose_b, c.a, c.pose_a);
      if (!q || q->depth != p->depth || q->normal != -p->normal || q->translation != -p->translation)
        problem = "swapped, it differs";
    }
    if (problem.empty() && random.oneIn(4)) problem = wrongWithMargin(random, c);
    if (problem.empty()) continue;
    const std::string found = p ? ", depth " + support::hex(p->depth) + ", bound " + support::hex(p->lower_bound) : "";
    run.fail(drawn.family, problem + found, support::reproduction(c));
  }
}

}  // namespace tricover::soak
