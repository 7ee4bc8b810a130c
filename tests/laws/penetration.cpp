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

/// Only the quarter beside the corner is free: the rest of the large polygon doesn't matter, however far it reaches.
std::string wrongInCorner(Random&, Tally& tally, Case& c) {
  const auto p = penetration(c.a, c.pose_a, c.b, c.pose_b);
  tally.count("hits", p.has_value());
  if (!p) return {};
  Vec2 least(0, 0);
  for (const Ring& ring : c.b.rings())
    for (const Vec2& v : ring) least = least.cwiseMin(c.pose_a.inverse(Eigen::Isometry) * (c.pose_b * v));
  const double precision = 1e-12 * c.b.radius() + 2e-13 * c.a.radius();
  if (!p->optimal || p->depth - p->lower_bound > 1.2 * precision) return "not optimal" + told(p);
  return std::abs(p->depth - least.norm()) <= precision ? "" : "depth, which is " + hex(least.norm()) + told(p);
}

/// A comb in the notch of a block, of which other edges of the comb run along the walls.
Case combInNotch(Random& random) {
  const double slope = std::pow(10, random.real(-5, -0.5)), size = slope * std::pow(10, random.real(-6, -0.5));
  const Polygon block({{{20, 20 * slope}, {0, 0}, {20, -20 * slope}, {20, -20}, {-20, -20}, {-20, 20}, {20, 20}}});
  Case c{Polygon({scaled(comb(random.integer(2, 4), 0.5, 0.25, 1), size)}), turnedAndMoved(random.real(0, 6), 0, 0),
         block, turnedAndMoved(random.coin() ? 0 : random.real(0, 6), 0, 0)};
  c.pose_a.translation() = c.pose_b * Vec2(random.real(-0.2, 0.2) * size / slope, 0);
  return c;
}

double slopeOf(const Case& c) { return c.b.rings()[0][0].y() / 20; }

/// The shortest way to where all vertices of the comb are within both walls: straight off one wall, or to the corner
/// of that region.
double wayIntoNotch(const Case& c) {
  const Pose back = c.pose_b.inverse(Eigen::Isometry) * c.pose_a;
  const Vec2 inwards[] = {Vec2(slopeOf(c), -1).normalized(), Vec2(slopeOf(c), 1).normalized()};
  double outside[] = {-1e300, -1e300};
  for (const Vec2& v : c.a.rings()[0])
    for (int i = 0; i < 2; ++i) outside[i] = std::max(outside[i], -inwards[i].dot(back * v));
  if (std::max(outside[0], outside[1]) <= 0) return 0;
  for (int i = 0; i < 2; ++i)
    if (outside[i] > 0 && outside[1 - i] <= outside[i] * inwards[0].dot(inwards[1])) return outside[i];
  return std::hypot((outside[0] + outside[1]) / (2 * inwards[0].x()), (outside[1] - outside[0]) / (2 * inwards[1].y()));
}

/// Found by the soak: near the notch's bottom the way is narrower than the search's resolution. The depth was the way
/// out of the whole block, 1e8 times as long, and the lower bound, too.
std::string wrongInNotch(Random&, Tally& tally, Case& c) {
  const auto p = penetration(c.a, c.pose_a, c.b, c.pose_b);
  tally.count("hits", p.has_value());
  if (!p) return {};
  tally.count("steep", slopeOf(c) < 1e-3);
  const double way = wayIntoNotch(c), precision = 1e-12 * c.a.radius() + 1e-13 * c.b.radius();
  const bool is_right = p->lower_bound <= way + precision && p->depth >= way - precision &&
                        p->depth - p->lower_bound <= (p->optimal ? 2 : 2 / slopeOf(c)) * precision;
  return is_right ? "" : "depth, which is " + hex(way) + told(p);
}

/// Squares of such lengths overflow or underflow. Where the way out ends between lines at a small angle, or goes on for
/// a margin, lengths in the world decide.
std::string wrongScaled(Random& random, Tally& tally, Case& c) {
  const double margin = random.coin() ? 0 : c.a.radius() * random.unit();
  const auto p = penetration(c.a, c.pose_a, c.b, c.pose_b, {margin});
  if (!p) return {};
  tally.count("optimal", p->optimal);
  for (const double by : {0x1p600, 0x1p-400}) {
    Pose pose_a = c.pose_a, pose_b = c.pose_b;
    pose_a.translation() *= by, pose_b.translation() *= by;
    const auto q = penetration(c.a.scaled(by), pose_a, c.b.scaled(by), pose_b, {margin * by});
    if (!q || q->depth != p->depth * by || q->lower_bound != p->lower_bound * by) return "scaled by " + hex(by);
  }
  return {};
}

Case ofAnyRatio(Random& random) {
  const auto shape = [&](double size) {
    const int corners = random.integer(3, 7);
    return Polygon({scaled(random.coin() ? anyConvex(random, 1) : star(random, corners, 0.3, 1), size)});
  };
  const Polygon a = shape(1), b = shape(std::pow(10, random.integer(-6, -1)));
  return {a, Pose::Identity(), b, randomPose(random, 1)};
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
  add(laws, {family("tiny_in_corner", tinyInCorner)}, 600, wrongInCorner, {{"hits", 0.5, 1}});
  add(laws, {family("comb_in_notch", combInNotch)}, 300, wrongInNotch, {{"hits", 0.5, 1}, {"steep", 0.25, 0.98}});
  add(laws, {family("comb_in_notch", combInNotch)}, 200, wrongScaled, {{"optimal", 0.02, 0.75}}, "scaled_");
  add(laws, {family("any_ratio", ofAnyRatio)}, 300, wrong, {{"hits", 0.1, 0.98}, {"optimal", 1, 1}});
  add(laws, families(), 300, wrong, {{"hits", 0.25, 0.98}, {"deep", 0.1, 1}, optimal});
  add(laws, anyPairs(limits), 100, wrong);
  add(laws, anyPairs(convex), 200, wrong, {{"hits", 0.02, 0.98}}, "both_");
  return laws;
}

const Register registered("penetration", penetrationLaws);

}  // namespace
}  // namespace tricover::laws
