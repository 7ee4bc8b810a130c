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
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();

/// b near where it is: certificates about these poses are about to be used at the case's own.
Pose elsewhere(Random& random, const Case& c) {
  const double size = std::min(c.a.radius(), c.b.radius()) * (random.coin() ? 1e-3 : random.coin() ? 1e-12 : 1.0);
  Pose result = pose(random.real(-1, 1) * (random.coin() ? 1e-3 : 1.0), 0, 0) * c.pose_b;  // as rigid as that is
  const Vec2 moved = c.pose_b.translation() + Vec2(random.real(-size, size), random.real(-size, size));
  if (moved.allFinite()) result.translation() = moved;
  return result;
}

/// What a margin leaves of the distance, whatever the options allow beside that: margins around the distance and below.
std::string wrongMargin(const Case& c, Random& random, const mpq_class& squared, LimitedOptions options,
                        PairCache& cache) {
  const double below = std::min(exact::distanceBelow(squared), nudged(kLargest, -2));
  options.margin = random.coin() ? below * random.unit() : std::max(nudged(below, random.integer(-1, 1)), 0.0);
  const bool within = exact::within(squared, mpq_class(options.margin));
  const DistanceResult results[] = {distance(c.a, c.pose_a, c.b, c.pose_b, options),
                                    distance(c.b, c.pose_b, c.a, c.pose_a, options),
                                    distance(c.a, c.pose_a, c.b, c.pose_b, cache, options)};
  for (const DistanceResult& r : results) {
    if ((r.distance == 0) != within) return "margin: zero or not";
    if (r.distance > options.limit && r.distance < kInfinity) return "margin: above the limit";
    if (r.distance == kInfinity) {
      if (below == nudged(kLargest, -2)) continue;
      // Rounded down to a double.
      const mpq_class sum = mpq_class(std::min(options.limit, kLargest)) + mpq_class(options.margin);
      if (exact::within(squared, mpq_class(sum.get_d()))) return "margin: not found";
      continue;
    }
    // Of the distance and the margin together.
    const mpq_class slack = (mpq_class(below) + options.margin) / mpq_class("100000000000000") + 0x1p-1073;
    const mpq_class result(r.distance), truth = result + mpq_class(options.margin) + slack;
    if (squared > truth * truth && !within) return "margin: below the truth";
    const mpq_class least =
        (result - mpq_class(options.absolute_error) - slack) / (1 + mpq_class(options.relative_error)) +
        mpq_class(options.margin) - slack;
    if (!within && sgn(least) > 0 && least * least > squared) return "margin: more than the options allow";
  }
  return {};
}

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

/// What the options allow.
std::string wrongOptions(const Case& c, Random& random, const mpq_class& squared, double cold, PairCache& cache) {
  LimitedOptions options;
  const double length = std::min(cold, kLargest) * random.real(0, 2);
  if (random.coin()) options.relative_error = random.coin() ? 0.5 : 1e-3;
  if (random.coin()) options.absolute_error = length;
  if (random.coin()) options.limit = limitAround(random, squared, cold);
  if (random.oneIn(4)) return wrongMargin(c, random, squared, options, cache);
  const bool no_errors = options.relative_error == 0 && options.absolute_error == 0;
  const DistanceResult results[] = {distance(c.a, c.pose_a, c.b, c.pose_b, options),
                                    distance(c.b, c.pose_b, c.a, c.pose_a, options),
                                    distance(c.a, c.pose_a, c.b, c.pose_b, cache, options)};
  for (const DistanceResult& r : results) {
    if (r.distance > options.limit && r.distance < kInfinity) return "above the limit";
    if (r.distance == kInfinity && cold < kInfinity) {
      if (options.limit == kInfinity || exact::within(squared, mpq_class(options.limit)))
        return "not found within the limit";
      if (no_errors && cold <= options.limit) return "not found at a limit of itself";
    }
    if ((r.distance == 0) != (cold == 0)) return "zero or not";
    if (r.distance == kInfinity) continue;
    const mpq_class result(r.distance), slack("1/100000000000000");
    const mpq_class least =
        (result - mpq_class(options.absolute_error) - 0x1p-1073) / (1 + mpq_class(options.relative_error));
    if (sgn(least) > 0 && least * least > squared * (1 + 3 * slack)) return "more than the options allow";
    if (squared > (result + 0x1p-1074) * (result + 0x1p-1074) * (1 + 3 * slack)) return "below the truth";
  }
  return {};
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
      const std::string allowed = wrongOptions(c, random, squared, cold.distance, cache);
      if (!allowed.empty()) return "options: " + allowed;
      if (distance(c.a, c.pose_a, c.b, c.pose_b, cache).distance != cold.distance) return "cache of other options";
      return {};
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

std::string familyName(const testing::TestParamInfo<Family>& family) { return family.param.name; }

INSTANTIATE_TEST_SUITE_P(Families, DistanceOracle, testing::ValuesIn(families()), familyName);

}  // namespace
}  // namespace tricover::support
