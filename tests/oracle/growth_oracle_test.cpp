// SPDX-License-Identifier: BSD-3-Clause
// The inputs whose costs exploded, small enough for exact rationals: what makes them cheap must not change an answer.
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <random>
#include <string>

#include "exact_reference.h"
#include "growth_inputs.h"
#include "laws.h"
#include "random.h"
#include "tricover/collide.h"
#include "tricover/distance.h"
#include "tricover/time_of_impact.h"

namespace tricover::support {
namespace {

class Growth : public testing::TestWithParam<growth::Kind> {};

TEST_P(Growth, KeepsToAllLaws) {
  Random random(1);
  PairCache old;
  for (const std::size_t n : {5u, 12u, 40u}) {
    const growth::Input in = GetParam().make(n);
    for (const double time : {0.0, 0.25, 0.75}) {
      const Case c{in.a, Pose::Identity(), in.b, in.motion.at(time)};
      for (const Touching touching : {Touching::Collides, Touching::Allowed})
        EXPECT_EQ(brokenLaw(c, 0, touching, areWithin(c, 0, touching), random, old), "") << n << ", " << time;
      const double found = distance(c.a, c.pose_a, c.b, c.pose_b).distance,
                   below = exact::distanceBelow(exact::distanceSquared(c.a, c.pose_a, c.b, c.pose_b));
      EXPECT_NEAR(found, below, 1e-14 * below) << n << ", " << time;
    }
  }
}

/// Never late: free at some times before. Hardly early: near each other.
TEST_P(Growth, ImpactsAreNeverLate) {
  for (const std::size_t n : {5u, 12u, 40u}) {
    const growth::Input in = GetParam().make(n);
    const auto collides = [&](double time) { return exact::collide(in.a, Pose::Identity(), in.b, in.motion.at(time)); };
    const auto impact = timeOfImpact(in.a, Motion::still(Pose::Identity()), in.b, in.motion);
    const double until = impact ? impact->time : 1;
    for (const double share : {0.0, 0.3, 0.7, 0.99}) {
      if (until == 0) break;
      EXPECT_FALSE(collides(share * until)) << n << ", " << share;
    }
    if (!impact) continue;
    // No faster than 5 in a unit of time, and at most 1e-6 early.
    const Pose pose = in.motion.at(impact->time);
    EXPECT_TRUE(exact::within(exact::distanceSquared(in.a, Pose::Identity(), in.b, pose), 5e-6)) << n;
  }
}

/// As many edges as it takes for nodes to be cut by their corners: free before by collide(), and near each other then.
TEST(GrowthOfImpacts, FansThatPassOrMeet) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  constexpr int kCases = 60;
  int hits = 0;
  for (int i = 0; i < kCases; ++i) {
    const double gap = std::copysign(std::pow(10, 2.5 * unit(random) - 4.5), unit(random));
    const double angle = i % 3 == 0 ? 0 : 0.3 * unit(random);
    const growth::Input in = growth::passingFans(300, gap, angle);
    const Motion still = Motion::still(Pose::Identity());
    const bool swapped = i % 2 == 1;
    const auto impact =
        swapped ? timeOfImpact(in.b, in.motion, in.a, still) : timeOfImpact(in.a, still, in.b, in.motion);
    const double until = impact ? impact->time : 1;
    for (const double share : {0.0, 0.3, 0.48, 0.49, 0.5, 0.51, 0.6, 0.9, 0.99, 0.9999}) {
      EXPECT_FALSE(collide(in.a, Pose::Identity(), in.b, in.motion.at(share * until)))
          << gap << ", " << angle << ", " << share;
    }
    if (!impact) continue;
    ++hits;
    EXPECT_LE(distance(in.a, Pose::Identity(), in.b, in.motion.at(impact->time)).distance, 5e-6)
        << gap << ", " << angle;
  }
  EXPECT_GT(hits, kCases / 5);
  EXPECT_LT(hits, kCases * 4 / 5);
}

std::string kindName(const testing::TestParamInfo<growth::Kind>& kind) {
  std::string name = kind.param.name;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Kinds, Growth, testing::ValuesIn(growth::allKinds()), kindName);

}  // namespace
}  // namespace tricover::support
