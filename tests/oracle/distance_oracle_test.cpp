// SPDX-License-Identifier: BSD-3-Clause
// distance() against the exact reference: every family, both orders, cold and with caches that saw other poses and
// other pairs; and what the options allow, no more.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "distance_laws.h"
#include "exact_reference.h"
#include "families.h"
#include "limited_distance.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/distance.h"

namespace tricover::support {
namespace {

constexpr int kCases = 1000;
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
  if (random.coin()) options.absolute_error = length;
  if (random.coin()) options.limit = limitAround(random, squared, cold);
  if (!random.oneIn(4)) return options;
  const double below = std::min(exact::distanceBelow(squared), nudged(kLargest, -2));
  options.margin = random.coin() ? below * random.unit() : std::max(nudged(below, random.integer(-1, 1)), 0.0);
  return options;
}

class DistanceOracle : public testing::TestWithParam<Family> {};

TEST_P(DistanceOracle, AgreesWithExactRationals) {
  const int cases = scaledCount(kCases);
  int hits = 0, near = 0, disagreements = 0;
  PairCache old;
  for (int i = 0; i < cases; ++i) {
    const auto seed = static_cast<std::uint64_t>(i) + 7000000;
    Case c = GetParam().make(seed);
    Random random(~seed);
    const double size = std::min({c.a.radius(), c.b.radius(), kLargest});
    if (random.oneIn(3)) {
      const Vec2 apart = c.pose_b.translation() + size * Vec2(random.real(-2, 2), random.real(-2, 2));
      if (apart.allFinite()) c.pose_b.translation() = apart;
    }
    const mpq_class squared = exact::distanceSquared(c.a, c.pose_a, c.b, c.pose_b);
    hits += sgn(squared) == 0;
    near += sgn(squared) != 0 && squared < mpq_class(1e-12 * size) * mpq_class(1e-12 * size);
    const DistanceResult cold = distance(c.a, c.pose_a, c.b, c.pose_b);
    const auto problem = [&]() -> std::string {
      if (!isRootOf(cold.distance, squared)) return "cold";
      if ((cold.distance == 0) != collide(c.a, c.pose_a, c.b, c.pose_b)) return "collide";
      const std::string points = wrongPoints(c, cold);
      if (!points.empty()) return points;
      if (!same(swapped(distance(c.b, c.pose_b, c.a, c.pose_a)), cold)) return "swapped";
      const DistanceResult others = distance(c.a, c.pose_a, c.b, c.pose_b, old);
      if (others.distance != cold.distance) return "cache of other pairs";
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
    }();
    if (problem.empty()) continue;
    if (++disagreements <= 3) {
      ADD_FAILURE() << GetParam().name << " seed " << seed << ": " << problem << ", cold " << hex(cold.distance)
                    << ", truth above " << hex(exact::distanceBelow(squared)) << "\n"
                    << reproduction(c);
    }
  }
  std::printf("%-22s %6d cases %6d hits %6d within 1e-12 %4d disagreements\n", GetParam().name, cases, hits, near,
              disagreements);
  EXPECT_EQ(disagreements, 0);
  if (cases >= 100) {
    EXPECT_GE(hits, 0.1 * cases);
    EXPECT_LE(hits, 0.85 * cases);
  }
}

INSTANTIATE_TEST_SUITE_P(Families, DistanceOracle, testing::ValuesIn(families()),
                         [](const auto& family) { return family.param.name; });

}  // namespace
}  // namespace tricover::support
