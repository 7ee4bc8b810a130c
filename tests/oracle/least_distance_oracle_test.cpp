// SPDX-License-Identifier: BSD-3-Clause
// leastDistance() against exact distances of vertices' paths, where polygons are only shifted, and against distances at
// many times for any motion and trajectory.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "conflict_laws.h"
#include "exact_reference.h"
#include "least_distance_laws.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/segment.h"

namespace tricover::support {
namespace {

struct Moving {
  Polygon a;
  Motion motion_a;
  Polygon b;
  Motion motion_b;
};

std::string reproductionOf(const Moving& m) {
  return reproduction({m.a, m.motion_a.start, m.b, m.motion_b.start}) + reproduction("motion_a", m.motion_a) +
         reproduction("motion_b", m.motion_b);
}

LeastDistanceOptions anyOptions(Random& random) {
  LeastDistanceOptions options;
  options.error = std::pow(10, -random.integer(2, 11));
  if (random.oneIn(3)) options.margin = 0.25 * random.integer(1, 12);
  return options;
}

/// Vertices, starts and shifts on a grid: sums are exact.
Moving onGrid(Random& random) {
  const auto polygon = [&] {
    if (random.oneIn(6)) return point({0, 0});
    Ring ring = star(random, random.integer(3, 8), 1, 4);
    for (Vec2& v : ring) v = v.array().round();
    return random.coin() ? Polygon({rectangle(-random.integer(1, 3), -random.integer(1, 3), 2, 1)}) : Polygon({ring});
  };
  const auto anywhere = [&](int most) {
    return Vec2(0.25 * random.integer(-4 * most, 4 * most), 0.25 * random.integer(-4 * most, 4 * most));
  };
  const Vec2 from = anywhere(12);
  Vec2 by = anywhere(16) - 1.5 * from;
  if (random.oneIn(3)) by[random.integer(0, 1)] = 0;
  const Vec2 of_a = random.coin() ? Vec2(Vec2::Zero()) : anywhere(4);
  return {polygon(), Motion::translation(Pose::Identity(), of_a), polygon(),
          Motion::translation(tricover::pose(from.x(), from.y()), by + of_a)};
}

TEST(LeastDistanceOracle, TranslationsAreAsNearAsTheyExactlyCome) {
  const int cases = scaledCount(1500);
  int meet = 0, at_ends = 0, ended = 0;
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i) + 5000);
    const Moving m = onGrid(random);
    const LeastDistanceOptions options = anyOptions(random);
    const LeastDistance found = leastDistance(m.a, m.motion_a, m.b, m.motion_b, options);
    const double truth = exact::distanceBelow(leastSquared(m.a, m.motion_a, m.b, m.motion_b)) - options.margin;
    const double rounding = 1e-13 * (lengthOf(m.a, m.motion_a, m.b, m.motion_b) + options.margin);
    meet += truth <= 0;
    at_ends += truth > 0 && (found.time == 0 || found.time == 1);
    ended += found.budget_ended;
    std::string wrong = wrongLeastDistance(m.a, m.motion_a, m.b, m.motion_b, options, found, 20);
    if (!(found.distance >= truth - rounding && found.distance <= std::max(truth, 0.0) + options.error + rounding))
      wrong += " not the exact one, " + hex(truth);
    ASSERT_TRUE(wrong.empty()) << i << ": " << wrong << ", found " << hex(found.distance) << ", error " << options.error
                               << ", margin " << options.margin << "\n"
                               << reproductionOf(m);
  }
  std::printf("%d cases, %d meet, %d are nearest at an end, %d budgets ended\n", cases, meet, at_ends, ended);
  if (cases < 400) return;
  EXPECT_GT(meet, cases / 10);
  EXPECT_GT(at_ends, cases / 20);
  EXPECT_GT(cases - meet - at_ends, cases / 5);
  EXPECT_EQ(ended, 0);
}

TEST(LeastDistanceOracle, NoSampleIsNearer) {
  const int cases = scaledCount(1500);
  int meet = 0, apart = 0, ended = 0;
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i) + 90000);
    const auto polygon = [&] {
      if (random.oneIn(8)) return random.coin() ? point({0, 0}) : segment({-1, 0}, {1, 0.5});
      return random.coin() ? Polygon({anyConvex(random, 1, 20)})
                           : Polygon({star(random, random.integer(4, 20), 0.3, 1)});
    };
    const Polygon a = polygon(), b = polygon();
    const Moving m{a, random.coin() ? Motion::still(randomPose(random, 1)) : randomMotion(random, a, 1), b,
                   randomMotion(random, b, 1.5)};
    const LeastDistanceOptions options = anyOptions(random);
    const LeastDistance found = leastDistance(m.a, m.motion_a, m.b, m.motion_b, options);
    const std::string wrong = wrongLeastDistance(m.a, m.motion_a, m.b, m.motion_b, options, found, 300);
    ++(found.distance == 0 ? meet : apart);
    ended += found.budget_ended;
    ASSERT_TRUE(wrong.empty()) << i << ": " << wrong << ", found " << hex(found.distance) << ", error " << options.error
                               << ", margin " << options.margin << "\n"
                               << reproductionOf(m);
  }
  std::printf("%d cases, %d meet, %d don't, %d budgets ended\n", cases, meet, apart, ended);
  if (cases < 400) return;
  EXPECT_GT(meet, cases / 10);
  EXPECT_GT(apart, cases / 10);
  EXPECT_LE(ended, cases / 100);
}

/// Bodies that may come later, leave sooner, or never be there together.
TEST(LeastDistanceOracle, NoSampleOfTrajectoriesIsNearer) {
  const int cases = scaledCount(600);
  int meet = 0, apart = 0, absent = 0, ended = 0;
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i) + 70000);
    const auto polygon = [&] {
      return random.oneIn(8) ? segment({-1, 0}, {1, 0.5}) : Polygon({star(random, random.integer(3, 20), 0.1, 0.4)});
    };
    const Polygon a = polygon(), b = polygon();
    const Trajectory of_a = anyPlan(random), of_b = anyPlan(random);
    LeastDistanceOptions options = anyOptions(random);
    if (options.margin > 0) options.margin = 0.1;
    options.absent_outside =
        std::max(of_a.begin(), of_b.begin()) <= std::min(of_a.end(), of_b.end()) && random.oneIn(3);
    const LeastDistance found = leastDistance(a, of_a, b, of_b, options);
    const std::string wrong = wrongLeastDistance(a, of_a, b, of_b, options, found, 500);
    ++(found.distance == 0 ? meet : apart);
    absent += options.absent_outside;
    ended += found.budget_ended;
    ASSERT_TRUE(wrong.empty()) << i << ": " << wrong << ", found " << hex(found.distance) << ", error " << options.error
                               << ", margin " << options.margin << ", absent outside " << options.absent_outside;
  }
  std::printf("%d cases, %d meet, %d don't, %d with bodies that are absent, %d budgets ended\n", cases, meet, apart,
              absent, ended);
  if (cases < 200) return;
  EXPECT_GT(meet, cases / 10);
  EXPECT_GT(apart, cases / 10);
  EXPECT_GT(absent, cases / 10);
  EXPECT_LE(ended, cases / 100);
}

}  // namespace
}  // namespace tricover::support
