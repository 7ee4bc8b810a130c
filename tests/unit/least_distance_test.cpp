// SPDX-License-Identifier: BSD-3-Clause
// Least distances known by hand. tests/laws/least_distance.cpp has those of random motions.
#include "tricover/least_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "refusal.h"
#include "shapes.h"
#include "tricover/conflicts.h"
#include "tricover/distance.h"
#include "tricover/segment.h"
#include "tricover/time_of_impact.h"

namespace tricover::support {
namespace {

constexpr double kErrors[] = {1e-2, 1e-6, 1e-9, 1e-12};

Motion still(double x, double y) { return Motion::still(tricover::pose(x, y)); }
Motion slide(double x, double y, const Vec2& shift) { return Motion::translation(tricover::pose(x, y), shift); }

LeastDistanceOptions within(double error, double margin = 0) {
  LeastDistanceOptions options;
  options.error = error;
  options.margin = margin;
  return options;
}

void expectLeast(const LeastDistance& found, double truth, double error) {
  EXPECT_FALSE(found.budget_ended);
  EXPECT_LE(found.lower_bound, truth + 1e-12);
  EXPECT_GE(found.distance, truth - 1e-14);
  EXPECT_LE(found.distance, truth + error + 1e-12);
  EXPECT_LE(found.distance - found.lower_bound, error + 1e-12);
}

TEST(LeastDistance, OfABodyThatPasses) {
  const Polygon shelf = box(2, 2), robot = box(1, 1);
  const Motion passes = slide(-3, 3, {6, -1});
  for (const double error : kErrors) {
    SCOPED_TRACE(error);
    const LeastDistance found = leastDistance(shelf, still(0, 0), robot, passes, within(error));
    expectLeast(found, 4.5 / std::sqrt(37), error);
    const auto there = distance(shelf, tricover::pose(0, 0), robot, passes.at(found.time));
    EXPECT_EQ(std::tie(found.distance, found.edge_a, found.edge_b),
              std::tie(there.distance, there.edge_a, there.edge_b));
    EXPECT_TRUE(found.point_a == there.point_a && found.point_b == there.point_b);
    expectLeast(leastDistance(robot, passes, shelf, still(0, 0), within(error, 0.5)), 4.5 / std::sqrt(37) - 0.5, error);
  }
}

TEST(LeastDistance, IsNothingWhereTheyMeet) {
  const Polygon square = box(1, 1);
  for (const Vec2& way : {Vec2(9, 0), Vec2(4, 0), Vec2(1, 0.75)}) {
    const LeastDistance found = leastDistance(square, still(0, 0), square, slide(-5, 0, way), within(1e-9, 3));
    EXPECT_EQ(found.distance, 0);
    EXPECT_EQ(found.lower_bound, 0);
    EXPECT_LE(distance(square, tricover::pose(0, 0), square, slide(-5, 0, way).at(found.time)).distance, 3 + 1e-12);
  }
  // Found by `soak impact --seed 77 --case 776`: at the end they are nearer to each other than the error.
  EXPECT_EQ(leastDistance(square, still(0, 0), square, slide(-5, 0, {6.125, 0}), within(0.5)).distance, 0);
  // They only touch, in passing.
  EXPECT_EQ(leastDistance(square, still(0, 0), square, slide(-5, 1, {10, 0})).distance, 0);
  EXPECT_EQ(leastDistance(square, still(0, 0), square, slide(-2, 0, {2, 2}), within(1e-9)).distance, 0);
}

/// Bodies that stay as far apart for all of the time.
TEST(LeastDistance, OfConstantGaps) {
  const Polygon floor = box(20, 1), crate = box(1, 1);
  Motion a = still(0, 0), b = still(-2, 1.25);
  a.angle = b.angle = 3;
  b.pivot = Vec2(2, -1.25);
  std::vector<TimedPose> waypoints;
  for (int i = 0; i <= 60; ++i) waypoints.push_back({static_cast<double>(i), tricover::pose(-9 + 0.3 * i, 1.25)});
  const Trajectory rests({{0, 60, still(0, 0)}}), slides = Trajectory::through(waypoints);
  const std::pair<Motion, Motion> motions[] = {
      {still(0, 0), slide(-5, 1.25, {10, 0})},
      {slide(0, 0, {3, 1}), slide(-2, 1.25, {3, 1})},
      {a, b},
      {still(0, 0), Motion::spline({{-5, 1.25}, 0, {6, 0}, 0}, {{5, 1.25}, 0, {8, 0}, 0})}};
  for (const double error : kErrors)
    for (const double margin : {0.0, 0.125}) {
      SCOPED_TRACE(error);
      const LeastDistanceOptions options = within(error, margin);
      for (const auto& [of_floor, of_crate] : motions)
        expectLeast(leastDistance(floor, of_floor, crate, of_crate, options), 0.25 - margin, error);
      expectLeast(leastDistance(floor, rests, crate, slides, options), 0.25 - margin, error);
    }
}

TEST(LeastDistance, ErrorsBelowRoundingEnd) {
  const Polygon shelf = box(2, 2), robot = box(1, 1);
  Motion turns = slide(-3, 3, {6, -1});
  turns.angle = 2;
  for (const double error : {1e-15, 1e-18, 1e-300, 5e-324}) {
    const LeastDistance found = leastDistance(shelf, still(0, 0), robot, turns, within(error));
    expectLeast(found, leastDistance(shelf, still(0, 0), robot, turns, within(1e-12)).distance, 1e-12);
  }
}

TEST(LeastDistance, TimesAreTheTrajectorys) {
  const Polygon post = box(1, 1), robot = box(1, 1);
  const Trajectory rests({{0, 100, still(0, 0)}});
  const Trajectory passes = Trajectory::through({{10, tricover::pose(-8, 2)}, {20, tricover::pose(8, 2)}});
  const LeastDistance found = leastDistance(post, rests, robot, passes);
  expectLeast(found, 1, 1e-6);
  EXPECT_GE(found.time, 14.3);
  EXPECT_LE(found.time, 15.7);
  // It rests where it begins: at times that the other one begins earlier, too.
  const Trajectory comes({{10, 20, slide(3, 0, {5, 0})}});
  EXPECT_EQ(leastDistance(post, rests, robot, comes).distance, 2);
  // Both are there from 12 to 15, when the second is farther away.
  const Trajectory later({{12, 15, still(0, 0)}});
  LeastDistanceOptions absent;
  absent.absent_outside = true;
  const LeastDistance there = leastDistance(post, later, robot, comes, absent);
  EXPECT_EQ(there.distance, distance(post, tricover::pose(0, 0), robot, comes.at(12)).distance);
  EXPECT_EQ(there.time, 12);
  const Trajectory never({{30, 40, still(0, 0)}});
  EXPECT_NE(refusal([&] { leastDistance(post, never, robot, comes, absent); }).find("absent_outside"),
            std::string::npos);
  // They are there together for an instant.
  const Trajectory at_once({{20, 30, still(0, 0)}});
  EXPECT_EQ(leastDistance(post, at_once, robot, comes, absent).distance, 7);
}

/// As timeOfImpact() and conflicts() say at the one instant at which both are there.
TEST(LeastDistance, AgreesAtAnInstant) {
  const Polygon body = box(1, 1);
  for (const double apart : {0.0, 1.0, 1.5}) {
    const Trajectory first({{0, 10, slide(0, 0, {10, 0})}}), then({{10, 20, slide(10 + apart, 0, {5, 0})}});
    LeastDistanceOptions absent;
    absent.absent_outside = true;
    const double least = leastDistance(body, first, body, then, absent).distance;
    EXPECT_EQ(least, std::max(apart - 1, 0.0));
    for (const double time_error : {0.0, 1e-6})
      for (const bool ignores : {false, true}) {
        const ImpactOptions options{0, time_error, ignores, true};
        const auto impact = timeOfImpact(body, first, body, then, options);
        const auto all = conflicts(body, first, body, then, options);
        ASSERT_EQ(impact.has_value(), least == 0 && !ignores);
        ASSERT_EQ(all.size(), impact.has_value() ? 1u : 0u);
        if (!impact) continue;
        EXPECT_EQ(impact->time, 10);
        EXPECT_EQ(all[0].impact.time, 10);
        EXPECT_EQ(all[0].end, 10);
        EXPECT_FALSE(all[0].budget_ended);
      }
  }
}

TEST(LeastDistance, LengthsThatOverflowEnd) {
  const Polygon post = box(1e307, 1e307);
  const LeastDistance found = leastDistance(post, still(-1.2e308, 0), post, slide(1.2e308, 0, {0, 1e307}));
  EXPECT_GT(found.distance, 1e308);
  EXPECT_LE(found.lower_bound, found.distance);
}

TEST(LeastDistance, RefusesBadOptions) {
  const Polygon square = box(1, 1);
  const auto refused = [&](const LeastDistanceOptions& options) {
    return refusal([&] { leastDistance(square, still(0, 0), square, still(3, 0), options); });
  };
  for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_NE(refused(within(1e-6, bad)).find("margin"), std::string::npos);
    EXPECT_NE(refused(within(bad)).find("error"), std::string::npos);
  }
  EXPECT_NE(refused(within(0)).find("error"), std::string::npos);
  Motion far = still(0, 0);
  far.shift.x() = std::nan("");
  EXPECT_NE(refusal([&] { leastDistance(square, far, square, still(0, 0)); }).find("motion_a"), std::string::npos);
}

}  // namespace
}  // namespace tricover::support
