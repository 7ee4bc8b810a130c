// SPDX-License-Identifier: BSD-3-Clause
// margin and tolerance against exact distances: equality, one ulp either side of it, and what a tolerance may answer.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>

#include "exact_reference.h"
#include "families.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "stages.h"
#include "strategies.h"
#include "test_scale.h"
#include "tricover/collide.h"

namespace tricover::support {
namespace {

constexpr int kCases = 300;
constexpr double kLargest = std::numeric_limits<double>::max();

struct Tally {
  int queries = 0, hits = 0, disagreements = 0;
};

/// The question asked in every way, `cache` being one that saw other margins; the truth lies between `must` and `may`.
void ask(const Case& c, const CollideOptions& options, bool must, bool may, StrategyCaches& cache, Tally& tally) {
  {
    const UpTo edges(detail::Stages::Edges);
    const Polygon a = afresh(c.a), b = afresh(c.b);
    for (const bool answer : {collide(a, c.pose_a, b, c.pose_b, options), collide(b, c.pose_b, a, c.pose_a, options)}) {
      if ((answer || !must) && (!answer || may)) continue;
      ++tally.disagreements;
      ADD_FAILURE() << "by edges alone, margin " << hex(options.margin) << ", tolerance " << hex(options.tolerance)
                    << "\n"
                    << reproduction(c);
    }
  }
  for (const Strategy strategy : {Strategy::Hierarchy, Strategy::Paper}) {
    const bool answers[] = {collide(strategy, c.a, c.pose_a, c.b, c.pose_b, options),
                            collide(strategy, c.b, c.pose_b, c.a, c.pose_a, options),
                            collide(strategy, c.a, c.pose_a, c.b, c.pose_b, cache, options)};
    for (const bool answer : answers) {
      ++tally.queries;
      tally.hits += answer;
      if ((answer || !must) && (!answer || may)) continue;
      if (++tally.disagreements <= 3) {
        ADD_FAILURE() << "answers (cold, swapped, cached) " << answers[0] << answers[1] << answers[2] << ", truth "
                      << must << " to " << may << ", margin " << hex(options.margin) << ", tolerance "
                      << hex(options.tolerance) << ", " << nameOf(strategy) << "\n"
                      << reproduction(c);
      }
      break;
    }
  }
}

/// Lengths around the pair's distance.
std::vector<double> lengthsAround(Random& random, const mpq_class& distance_squared, double size) {
  const double below = exact::distanceBelow(distance_squared);
  std::vector<double> lengths = {
      0, below, nudged(below, 1), nudged(below, 2), below * (1 + 1e-12), below * 2, size * random.unit()};
  if (below > 0) lengths.insert(lengths.end(), {nudged(below, -1), below * (1 - 1e-12), below / 2});
  for (double& length : lengths) length = std::min(length, kLargest);
  return lengths;
}

class DistanceOptionsOracle : public testing::TestWithParam<Family> {};

TEST_P(DistanceOptionsOracle, MarginIsExactAndToleranceKeepsItsPromise) {
  Tally tally;
  StrategyCaches old;
  for (int i = 0; i < scaledCount(kCases); ++i) {
    const auto seed = static_cast<std::uint64_t>(i) + 1000000;
    Case c = GetParam().make(seed);
    Random random(seed);
    const double size = std::min({c.a.radius(), c.b.radius(), kLargest});
    if (random.coin()) {
      const Vec2 apart = c.pose_b.translation() + size * Vec2(random.real(-2, 2), random.real(-2, 2));
      if (apart.allFinite()) c.pose_b.translation() = apart;
    }
    const mpq_class squared = exact::distanceSquared(c.a, c.pose_a, c.b, c.pose_b);
    StrategyCaches fresh;
    StrategyCaches& cache = random.coin() ? old : fresh;
    for (const double margin : lengthsAround(random, squared, size)) {
      const bool truth = exact::within(squared, mpq_class(margin));
      CollideOptions options;
      options.margin = margin;
      ask(c, options, truth, truth, cache, tally);
      options.margin = random.coin() ? 0 : margin / 2;
      options.tolerance = margin;
      ask(c, options, exact::within(squared, mpq_class(options.margin)),
          exact::within(squared, mpq_class(options.margin) + mpq_class(margin)), cache, tally);
    }
  }
  std::printf("%-22s %6d queries %6d hits %4d disagreements\n", GetParam().name, tally.queries, tally.hits,
              tally.disagreements);
  EXPECT_EQ(tally.disagreements, 0);
  EXPECT_GE(tally.hits, 0.2 * tally.queries);
  EXPECT_LE(tally.hits, 0.9 * tally.queries);
}

std::string familyName(const testing::TestParamInfo<Family>& family) { return family.param.name; }

INSTANTIATE_TEST_SUITE_P(Families, DistanceOptionsOracle, testing::ValuesIn(families()), familyName);

/// Distances that are doubles: 3-4-5 between two vertices, and the gap between two parallel edges, at every size.
TEST(Margin, EqualityIsIncluded) {
  for (const double unit : {1.0, 0x1p-498, 0x1p498, 0x1p990, 0x1p-1070}) {
    const Polygon a({scaled(rectangle(0, 0, 1, 1), unit)});
    for (const Vec2& by : {Vec2(4, 5), Vec2(-5, 4), Vec2(6, 0.5), Vec2(0, -6)}) {
      const double distance = 5 * unit;
      Pose pose_b = Pose::Identity();
      pose_b.translation() = by * unit;
      for (const Strategy strategy : {Strategy::Hierarchy, Strategy::Paper}) {
        const auto within = [&](double margin) { return collide(strategy, a, Pose::Identity(), a, pose_b, {margin}); };
        EXPECT_TRUE(within(distance)) << hex(unit);
        EXPECT_FALSE(within(nudged(distance, -1))) << hex(unit);
        EXPECT_TRUE(within(nudged(distance, 1))) << hex(unit);
        EXPECT_TRUE(within(kLargest)) << hex(unit);
      }
    }
  }
}

}  // namespace
}  // namespace tricover::support
