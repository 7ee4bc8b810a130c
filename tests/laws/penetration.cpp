// SPDX-License-Identifier: BSD-3-Clause
// penetration() against brute force on rationals, and its promises: the translation parts them, shorter ones don't,
// with swapped operands the result is mirrored.
#include "tricover/penetration.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "contact_laws.h"
#include "exact_penetration.h"
#include "exact_reference.h"
#include "families.h"
#include "law.h"
#include "pairs.h"
#include "penetration_laws.h"
#include "reference.h"
#include "reproduction.h"
#include "shapes.h"

namespace tricover::laws {
namespace {

using namespace support;

std::string told(const std::optional<Penetration>& p) {
  return p ? ", depth " + hex(p->depth) + ", bound " + hex(p->lower_bound) : "";
}

/// With a margin the way leads to where they are farther apart than that, and none that is shorter does.
std::string wrongWithMargin(Random& random, const Case& c) {
  const double margin = random.unit() * std::max(c.a.radius(), c.b.radius());
  if (!std::isfinite(margin)) return {};
  const std::string wrong = wrongPenetration(random, c, margin, penetration(c.a, c.pose_a, c.b, c.pose_b, {margin}), 4);
  return wrong.empty() ? wrong : wrong + " with the margin " + hex(margin);
}

std::string wrongWith(Random& random, Tally& tally, const Case& c, const std::optional<Penetration>& p,
                      int directions) {
  tally.count("hits", p.has_value());
  const std::string wrong = wrongPenetration(random, c, 0, p, directions);
  if (!wrong.empty() || !p) return wrong;
  tally.count("deep", p->depth > 1e-6 * smallerRadius(c));
  tally.count("optimal", p->optimal);
  return std::isinf(p->depth) ? "" : wrongSwapped(c, *p);
}

std::string wrongByBruteForce(const Case& c, const Penetration& p, double bound, double error) {
  const double truth = exact::penetrationDepth(c.a, c.pose_a, c.b, c.pose_b, bound);
  return std::abs(p.depth - truth) <= error + 1e-11 * (c.a.radius() + c.b.radius())
             ? ""
             : "depth by brute force, which is " + hex(truth);
}

double boundOf(const Case& c) { return (1 + 1e-9) * exact::hullDepth(c.a, c.pose_a, c.b, c.pose_b); }

bool isSmall(const Case& c) {
  return c.a.vertexCount() * c.b.vertexCount() <= 30 && smallerRadius(c) > 1e-3 && c.a.radius() < 1e3 &&
         c.b.radius() < 1e3 && c.pose_b.translation().norm() < 1e3;
}

std::string wrong(Random& random, Tally& tally, Case& c) {
  c = pushed(random, c);
  const auto p = penetration(c.a, c.pose_a, c.b, c.pose_b);
  std::string problem = wrongWith(random, tally, c, p, 8);
  if (problem.empty() && random.oneIn(25)) problem = wrongWithMargin(random, c);
  if (problem.empty() && p && smallerRadius(c) > 1e-280 && isStrictlyConvex(c.a) && isStrictlyConvex(c.b))
    problem = wrongConvexDepth(c, p->depth);
  else if (problem.empty() && p && p->optimal && isSmall(c) && random.oneIn(100))
    problem = wrongByBruteForce(c, *p, boundOf(c), 2 * precisionOf(c));
  return problem.empty() ? problem : problem + told(p);
}

Polygon smallPolygon(Random& random) {
  const FillRule fill = random.coin() ? FillRule::EvenOdd : FillRule::NonZero;
  switch (random.integer(0, 4)) {
    case 0:
      return Polygon({star(random, random.integer(4, 6), 0.3, 2)}, fill);
    case 1:
      return Polygon({comb(2, 0.5, 0.25, 1)}, fill);
    case 2: {
      Ring hole = reversed(star(random, 3, 0.3, 0.9));
      return Polygon({star(random, 4, 1.2, 2), hole}, fill);
    }
    case 3: {
      Ring ring;
      for (int i = random.integer(4, 5); i > 0; --i) ring.emplace_back(random.real(-1, 1), random.real(-1, 1));
      return Polygon({ring}, fill);
    }
    default: {
      Ring ring;
      for (int i = random.integer(4, 6); i > 0; --i) ring.emplace_back(random.integer(-2, 2), random.integer(-2, 2));
      return Polygon({ring}, fill);
    }
  }
}

Case smallPair(Random& random) {
  const bool turned = random.coin();
  const auto anyPoseNear = [&] {
    const double x = random.integer(-4, 4) / 4.0, y = random.integer(-4, 4) / 4.0;
    Pose result =
        turned ? turnedAndMoved(random.real(0, 6.3), random.real(-1, 1), random.real(-1, 1)) : turnedAndMoved(0, x, y);
    return random.oneIn(4) ? mirrored(result) : result;
  };
  const Pose pose_a = anyPoseNear(), pose_b = anyPoseNear();
  const Polygon a = smallPolygon(random), b = smallPolygon(random);
  return {a, pose_a, b, pose_b};
}

/// Of few vertices: beside brute force.
std::string wrongSmall(Random& random, Tally& tally, Case& c) {
  const auto p = penetration(c.a, c.pose_a, c.b, c.pose_b);
  std::string problem = wrongWith(random, tally, c, p, 64);
  if (!problem.empty() || !p) return problem;
  const double bound = boundOf(c);
  tally.count("less deep than the hulls", p->depth < (1 - 1e-9) * bound);
  problem = wrongByBruteForce(c, *p, bound, 0);
  return problem.empty() ? problem : problem + told(p);
}

/// Searches so long that the regions are covered by discs.
Case manyVertices(Random& random) {
  const auto outline = [&] { return Polygon({star(random, 250, 1.9, 2), reversed(star(random, 20, 0.2, 0.5))}); };
  const Polygon a = outline(), b = outline();
  return {a, turnedAndMoved(1, 3e5, -2e5), b, turnedAndMoved(random.real(0, 6.3), 3e5, -2e5 + random.unit())};
}

std::string wrongDeep(Random& random, Tally& tally, Case& c) {
  return wrongWith(random, tally, c, penetration(c.a, c.pose_a, c.b, c.pose_b), 200);
}

/// Squares of size 1 in a grid of pitch 2, some left out: translations overlap on whole cells of that grid, each by as
/// many pairs of squares as are that far from each other. The nearest cell that none is on is known.
std::string wrongOfSquares(Random& random, Tally& tally) {
  const int n = random.integer(4, 12), cells = 2 * n + 1;
  const double share = random.real(0.3, 1);
  std::vector<std::pair<int, int>> places[2];
  std::vector<Ring> rings[2];
  for (const int side : {0, 1})
    for (int k = 0; k < n * n; ++k) {
      if (k > 0 && random.unit() > share) continue;
      const int x = k % n, y = k / n;
      places[side].emplace_back(x, y);
      rings[side].push_back(rectangle(2 * x, 2 * y, 2 * x + 1, 2 * y + 1));
    }
  std::vector<char> taken(static_cast<std::size_t>(cells * cells));
  for (const auto& [x, y] : places[0])
    for (const auto& [u, v] : places[1]) taken[static_cast<std::size_t>((y - v + n) * cells + x - u + n)] = true;
  const Vec2 shift(random.real(-1, 1), random.real(-1, 1));
  double truth = 4 * n;
  for (int x = -n; x <= n; ++x)
    for (int y = -n; y <= n; ++y)
      if (!taken[static_cast<std::size_t>((y + n) * cells + x + n)])
        truth = std::min(truth, ((shift - 2 * Vec2(x, y)).cwiseAbs().cwiseMax(1) - Vec2(1, 1)).norm());
  const Pose frame = random.coin() ? Pose::Identity() : turnedAndMoved(random.real(0, 6.3), 5, -7);
  const Case c{Polygon(rings[0]), frame, Polygon(rings[1]), moved(frame, frame.linear() * shift)};

  const auto p = penetration(c.a, c.pose_a, c.b, c.pose_b);
  std::string wrong = p.has_value() != (truth > 0) ? "whether they meet" : wrongWith(random, tally, c, p, 64);
  if (p) tally.count("by many squares", truth > 4);
  if (wrong.empty() && p && !(std::abs(p->depth - truth) <= 1e-11 * n)) wrong = "depth, which is " + hex(truth);
  return wrong.empty() ? wrong : wrong + told(p) + "\n" + reproduction(c);
}

Case convexPair(Random& random) {
  const double scale = std::ldexp(1.0, random.integer(-3, 3) * (random.oneIn(3) ? 100 : 1));
  const double offset = random.oneIn(4) ? 1e9 : 1;
  const auto convex = [&] { return eitherWay(random, anyConvex(random, random.real(0.1, 2) * scale, 12)); };
  const Polygon a({convex()}), b({convex()});
  Case c{a, randomPose(random, offset * scale), b, randomPose(random, 0)};
  const Vec2 way = direction(random.real(0, 6.3)) * (random.unit() * (c.a.radius() + c.b.radius()));
  c.pose_b.translation() = c.pose_a.translation() + way;
  if (random.coin())
    if (const auto deep = penetration(c.a, c.pose_a, c.b, c.pose_b))
      c.pose_b.translation() += (1 - std::exp2(random.real(-40, 0))) * deep->translation;
  return c;
}

/// Exact to rounding.
std::string wrongConvex(Random& random, Tally& tally, Case& c) {
  const auto p = penetration(c.a, c.pose_a, c.b, c.pose_b);
  const std::string problem = wrongWith(random, tally, c, p, 8);
  if (!problem.empty() || !p) return problem;
  tally.count("shallow", p->depth < 1e-3 * smallerRadius(c));
  const double truth = exact::distanceBelow(exact::convexPenetrationSquared(c.a, c.pose_a, c.b, c.pose_b));
  if (!(std::abs(p->depth - truth) <= 1e-14 * truth)) return "depth, which is " + hex(truth) + told(p);
  return p->optimal && p->lower_bound == p->depth ? "" : "it isn't optimal";
}

Laws penetrationLaws() {
  Limits limits;
  limits.most_exponent = 280;
  limits.most_vertices = 16;
  Limits convex = limits;
  convex.convex = true;
  const Share optimal{"optimal", 0.98, 1};
  Laws laws = {
      {"repeated_squares", 40, wrongOfSquares, {{"hits", 0.5, 1}, {"by many squares", 0.25, 0.98}, {"optimal", 1, 1}}}};
  add(laws, {family("small", smallPair)}, 600, wrongSmall,
      {{"hits", 0.5, 0.98}, {"less deep than the hulls", 0.333, 0.98}, {"optimal", 1, 1}});
  add(laws, {family("many_vertices", manyVertices)}, 6, wrongDeep, {{"hits", 1, 1}, {"optimal", 1, 1}});
  add(laws, {family("convex", convexPair)}, 3000, wrongConvex, {{"hits", 0.333, 0.98}, {"shallow", 0.001, 0.9}});
  add(laws, families(), 300, wrong, {{"hits", 0.25, 0.98}, {"deep", 0.1, 1}, optimal});
  add(laws, anyPairs(limits), 100, wrong);
  add(laws, anyPairs(convex), 200, wrong, {{"hits", 0.02, 0.98}}, "both_");
  return laws;
}

const Register registered("penetration", penetrationLaws);

}  // namespace
}  // namespace tricover::laws
