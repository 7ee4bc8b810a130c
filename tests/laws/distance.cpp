// SPDX-License-Identifier: BSD-3-Clause
// distance(), distanceWithin() and signedDistance() against exact rationals: in both orders, with caches, and what
// options allow.
#include "tricover/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "contact_laws.h"
#include "distance_laws.h"
#include "exact_reference.h"
#include "families.h"
#include "law.h"
#include "limited_distance.h"
#include "pairs.h"
#include "reference.h"
#include "reproduction.h"
#include "shapes.h"
#include "tricover/collide.h"
#include "tricover/polygon.h"
#include "tricover/signed_distance.h"

namespace tricover::laws {
namespace {

using namespace support;

constexpr double kLargest = std::numeric_limits<double>::max();

/// Limits around the truth, as near as an ulp.
double limitAround(Random& random, const mpq_class& squared, double cold) {
  switch (random.integer(0, 3)) {
    case 0:
      return cold;
    case 1:
      return exact::distanceBelow(squared);
    case 2:
      return nudged(std::min(exact::distanceBelow(squared), nudged(kLargest, -8)), random.integer(0, 8));
    default:
      return std::min(cold, kLargest) * random.real(0, 2);
  }
}

LimitedOptions anyOptions(Random& random, const mpq_class& squared, double cold) {
  LimitedOptions options;
  const double length = std::min(cold, kLargest) * random.real(0, 2);
  if (random.coin()) options.relative_error = random.coin() ? 0.5 : 1e-3;
  if (random.coin()) options.absolute_error = random.coin() ? length : 1e-3 * length;
  if (random.coin()) options.limit = limitAround(random, squared, cold);
  if (!random.oneIn(3)) return options;
  const double below = std::min(exact::distanceBelow(squared), nudged(kLargest, -2));
  options.margin = random.oneIn(3) ? length
                   : random.coin() ? below * random.unit()
                                   : std::max(nudged(below, random.integer(-1, 1)), 0.0);
  return options;
}

std::string wrongWith(Random& random, const Case& c, const mpq_class& squared, const DistanceResult& cold) {
  if (!isRootOf(cold.distance, squared)) return "cold";
  if ((cold.distance == 0) != collide(c.a, c.pose_a, c.b, c.pose_b)) return "collide";
  const std::string points = wrongPoints(c, cold);
  if (!points.empty()) return points;
  if (!same(swapped(distance(c.b, c.pose_b, c.a, c.pose_a)), cold)) return "swapped";
  PairCache old = cachesOfOthers(random).of_pair;
  if (distance(c.a, c.pose_a, c.b, c.pose_b, old).distance != cold.distance) return "cache of other pairs";
  PairCache cache;
  for (int k = 0; k < 3; ++k) distance(c.a, c.pose_a, c.b, elsewhere(random, c), cache);
  const DistanceResult cached = distance(c.a, c.pose_a, c.b, c.pose_b, cache);
  if (cached.distance != cold.distance) return "cache of other poses";
  if (!wrongPoints(c, cached).empty()) return "cache of other poses: " + wrongPoints(c, cached);
  if (distance(c.b, c.pose_b, c.a, c.pose_a, cache).distance != cold.distance) return "that cache again, swapped";
  const LimitedOptions options = anyOptions(random, squared, cold.distance);
  const std::string wrong = wrongDistances(c, options, squared, cache);
  if (!wrong.empty()) return wrong;
  if (cold.distance <= options.limit && options.margin + options.relative_error + options.absolute_error == 0 &&
      distance(c.a, c.pose_a, c.b, c.pose_b, options).distance != cold.distance)
    return "a limit changes it";
  if (distance(c.a, c.pose_a, c.b, c.pose_b, cache).distance != cold.distance) return "cache of other options";
  return random.oneIn(3) ? wrongSignedDistance(c, random.coin() ? options.margin : 0) : "";
}

std::string wrong(Random& random, Tally& tally, Case& c) {
  if (random.oneIn(3)) {
    const double size = std::min(smallerRadius(c), kLargest);
    const Vec2 apart = c.pose_b.translation() + size * Vec2(random.real(-2, 2), random.real(-2, 2));
    if (apart.allFinite()) c.pose_b.translation() = apart;
  }
  const mpq_class squared = Reference(c).distanceSquared();
  tally.count("hits", sgn(squared) == 0);
  const DistanceResult cold = distance(c.a, c.pose_a, c.b, c.pose_b);
  const std::string problem = wrongWith(random, c, squared, cold);
  return problem.empty()
             ? problem
             : problem + ", cold " + hex(cold.distance) + ", truth above " + hex(exact::distanceBelow(squared));
}

/// So flat that nothing but exact arithmetic tells the edges' distances apart.
Case squeezedFlat(Random& random) {
  const double flat = std::ldexp(1, -random.integer(47, 51)), angle = random.real(0, 3);
  const double gap = flat * (random.oneIn(4) ? random.real(0, 1) : random.real(2, 2.01));
  const auto polygon = [&] {
    Ring ring;
    for (int i = 0; i < 24; ++i) ring.emplace_back(random.real(-1, 1), flat * random.real(-1, 1));
    return Polygon({ring});
  };
  const Polygon a = polygon(), b = polygon();
  return {a, turnedAndMoved(angle, 0, 0), b, turnedAndMoved(angle, -std::sin(angle) * gap, std::cos(angle) * gap)};
}

/// Boxes' gaps are above the distance and below, both by no more than a float's rounding.
Case roundFarApart(Random& random) {
  const Polygon round({regular(65, 1)}), other({regular(65, 1)});
  Pose pose_b = turnedAndMoved(random.real(0, 6), 0, 0);
  pose_b.translation() = std::pow(10, random.real(0, 7)) * direction(random.real(0, 6.3));
  return {round, turnedAndMoved(random.real(0, 6), 0, 0), other, pose_b};
}

/// A vertex is beside an edge's end or, by less than doubles tell, beside its inner.
Case besideAnEnd(Random& random) {
  const double size = std::pow(10, random.real(-12, 0)), past = random.coin() ? 0 : std::pow(10, random.real(-10, -7));
  const Pose pose_b = randomPose(random, 1);
  Pose pose_a = pose_b;
  pose_a.translation() = pose_b * Vec2(past, -random.real(0.1, 1));
  return {Polygon({{{0, 0}, {-size, -size}, {size, -0.7 * size}}}), pose_a, Polygon::segment({0, 0}, {1, 0}), pose_b};
}

std::string wrongNormal(Random&, Tally& tally, Case& c) {
  const SignedDistance s = signedDistance(c.a, c.pose_a, c.b, c.pose_b);
  tally.count("ends", s.point_b == c.pose_b.translation());
  const bool leads = (s.point_b - s.point_a - s.distance * s.normal).norm() <= 1e-14;
  return leads ? "" : "the normal doesn't lead from point to point";
}

Case twoConvex(Random& random) {
  const Polygon a({anyConvex(random, 1)}), b({anyConvex(random, random.real(0.1, 2))});
  const Pose pose_a = randomPose(random, 1);
  return {a, pose_a, b, randomPose(random, 2)};
}

/// Moved along the normal convex polygons that are apart are farther apart, by no less; others by no more, either way.
std::string wrongAlongNormal(Random& random, Tally& tally, Case& c) {
  const SignedDistance before = signedDistance(c.a, c.pose_a, c.b, c.pose_b);
  const bool is_deep = before.distance < 0;
  const double by = random.real(0, 2) * (is_deep ? 1e-3 : 1);
  const double after = signedDistance(c.a, c.pose_a, c.b, moved(c.pose_b, by * before.normal)).distance;
  tally.count("deep", is_deep);
  if (is_deep) tally.count("shallower", after > before.distance);
  const bool is_right =
      after >= before.distance + (is_deep ? -by : by) - 1e-13 && (!is_deep || after <= before.distance + by + 1e-13);
  return is_right ? "" : "by " + hex(by) + " from " + hex(before.distance) + " to " + hex(after);
}

Laws distanceLaws() {
  Laws laws;
  add(laws, {family("round_far_apart", roundFarApart)}, 1000, wrong, {{"hits", 0.01, 0.5}});
  add(laws, {family("squeezed_flat", squeezedFlat)}, 100, wrong, {{"hits", 0.05, 0.5}});
  add(laws, {family("beside_an_end", besideAnEnd)}, 20000, wrongNormal, {{"ends", 0.1, 0.9}});
  add(laws, {family("along_normal", twoConvex)}, 3000, wrongAlongNormal, {{"deep", 0.2, 0.8}, {"shallower", 0.5, 1}});
  add(laws, {family("among_many_rings", smallAmongManyRings)}, 2000, wrong, {{"hits", 0.2, 0.8}});
  add(laws, families(), 1000, wrong, {{"hits", 0.1, 0.85}});
  add(laws, anyPairs(), 1000, wrong);
  return laws;
}

const Register registered("distance", distanceLaws);

}  // namespace
}  // namespace tricover::laws
