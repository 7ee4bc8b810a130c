// SPDX-License-Identifier: BSD-3-Clause
// Bodies that start in contact, and contact that lasts: it is proven by the features that are in contact, not by steps
// of time_error. A step of these tests that took them would not end.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "shapes.h"
#include "tricover/collide.h"
#include "tricover/conflicts.h"
#include "tricover/segment.h"
#include "tricover/time_of_impact.h"
#include "tricover/trajectory.h"

namespace tricover::support {
namespace {

constexpr double kErrors[] = {1e-2, 1e-6, 1e-9, 1e-12};

Motion still(double x, double y) { return Motion::still(tricover::pose(x, y)); }
Motion slide(double x, double y, const Vec2& shift) { return Motion::translation(tricover::pose(x, y), shift); }

ImpactOptions within(double time_error, bool ignore_initial = false, double margin = 0) {
  ImpactOptions options;
  options.time_error = time_error;
  options.ignore_initial = ignore_initial;
  options.margin = margin;
  return options;
}

void expectOne(const std::vector<Conflict>& found, double begin, double end, double error) {
  ASSERT_EQ(found.size(), 1u);
  EXPECT_FALSE(found[0].budget_ended);
  EXPECT_LE(found[0].impact.time, begin + 1e-12);
  EXPECT_GE(found[0].impact.time, begin - error);
  EXPECT_GE(found[0].end, end - 1e-12);
  EXPECT_LE(found[0].end, end + error);
}

TEST(LastingContact, ACrateOnAFloor) {
  const Polygon floor = box(20, 1), crate = box(1, 1);
  for (const double error : kErrors) {
    SCOPED_TRACE(error);
    const Motion slides = slide(-2, 1, {4, 0}), leaves = slide(-2, 1, {40, 0});
    EXPECT_FALSE(timeOfImpact(floor, still(0, 0), crate, slides, within(error, true)));
    expectOne(conflicts(floor, still(0, 0), crate, slides, within(error)), 0, 1, error);
    EXPECT_TRUE(conflicts(floor, still(0, 0), crate, slides, within(error, true)).empty());
    // Its lower left corner leaves the floor's end at x = 10.
    expectOne(conflicts(floor, still(0, 0), crate, leaves, within(error)), 0, 12.5 / 40, std::max(error, 1e-9));
    EXPECT_FALSE(timeOfImpact(floor, still(0, 0), crate, leaves, within(error, true)));
    // Both move alike, and both rotate alike about one place.
    expectOne(conflicts(floor, slide(0, 0, {3, 1}), crate, slide(-2, 1, {3, 1}), within(error)), 0, 1, error);
    Motion a = still(0, 0), b = still(-2, 1);
    a.angle = b.angle = 1;
    b.pivot = Vec2(2, -1);
    expectOne(conflicts(floor, a, crate, b, within(error)), 0, 1, error);
    // Along a cubic at the same height.
    const Motion spline = Motion::spline({{-5, 1}, 0, {6, 0}, 0}, {{5, 1}, 0, {8, 0}, 0});
    expectOne(conflicts(floor, still(0, 0), crate, spline, within(error)), 0, 1, error);
  }
}

TEST(LastingContact, LanesAtExactlyTheMargin) {
  const Polygon robot = box(1, 0.8);
  const Motion east = slide(-5, 0, {10, 0}), west = slide(5, 1, {-10, 0});
  for (const double error : kErrors) {
    SCOPED_TRACE(error);
    EXPECT_TRUE(conflicts(robot, east, robot, west, within(error, false, 0.19)).empty());
    // They are beside each other while their centres are within 1 along x. At the ends of contact, the distance changes
    // with the square of what is left: 1e-13 of a length are 1e-7 of it.
    expectOne(conflicts(robot, east, robot, west, within(error, false, 0.2)), 0.45, 0.55, std::max(error, 1e-7));
    const double beyond = std::sqrt(0.21 * 0.21 - 0.2 * 0.2) / 20;
    expectOne(conflicts(robot, east, robot, west, within(error, false, 0.21)), 0.45 - beyond, 0.55 + beyond,
              std::max(error, 1e-9));
  }
}

TEST(LastingContact, OverManyFeatures) {
  Ring flat, teeth;
  for (int i = 0; i <= 2000; ++i) {
    flat.emplace_back(-10 + 0.01 * i, 0);
    teeth.emplace_back(-10 + 0.01 * i, i % 7 == 3 ? 0 : -0.1 - 0.01 * (i % 5));
  }
  for (Ring* ring : {&flat, &teeth}) {
    ring->insert(ring->end(), {{10, -1}, {-10, -1}});
    const Polygon floor(*ring);
    expectOne(conflicts(floor, still(0, 0), box(1, 1), slide(-8, 0.5, {16, 0}), within(1e-9)), 0, 1, 0);
  }
  std::vector<TimedPose> waypoints;
  for (int i = 0; i <= 60; ++i) waypoints.push_back({static_cast<double>(i), tricover::pose(-9 + 0.3 * i, 1)});
  const Trajectory rests({{0, 60, still(0, 0)}}), slides = Trajectory::through(waypoints);
  const Polygon floor = box(20, 1), crate = box(1, 1);
  EXPECT_FALSE(timeOfImpact(floor, rests, crate, slides, within(1e-6, true)));
  expectOne(conflicts(floor, rests, crate, slides, within(1e-6)), 0, 60, 0);
  EXPECT_TRUE(conflicts(floor, rests, crate, slides, within(1e-6, true)).empty());
}

/// Docks written in decimals, of which many are a rounding apart or in each other.
TEST(ContactAtTheStart, DocksAreLeftFreely) {
  int apart = 0, together = 0;
  for (int i = 1; i <= 20; ++i)
    for (int j = 1; j <= 40; ++j) {
      const double of_floor = 0.05 * i, of_robot = 0.05 * j;
      char text[16];
      std::snprintf(text, sizeof text, "%.2f", of_floor + of_robot);
      const double at = std::atof(text);
      const Polygon floor({rectangle(-5, -of_floor, 5, of_floor)});
      const Polygon robot({rectangle(-0.5, -of_robot, 0.5, of_robot)});
      const bool touch = collide(floor, tricover::pose(0, 0), robot, tricover::pose(0, at));
      ++(touch ? together : apart);
      EXPECT_FALSE(timeOfImpact(floor, still(0, 0), robot, slide(0, at, {0, 1}), within(1e-6, true))) << text;
      EXPECT_TRUE(conflicts(floor, still(0, 0), robot, slide(0, at, {0, 1}), within(1e-6, true)).empty()) << text;
      // Down into it: there is no end of contact. Away and back: that is an impact.
      EXPECT_FALSE(timeOfImpact(floor, still(0, 0), robot, slide(0, at, {0, -0.04}), within(1e-6, true))) << text;
      Motion returns = slide(0, at, {0, 4});
      returns.shift_2 = Vec2(0, -8);
      const auto impact = timeOfImpact(floor, still(0, 0), robot, returns, within(1e-6, true));
      ASSERT_TRUE(impact) << text;
      EXPECT_NEAR(impact->time, 0.5, 2e-6) << text;
    }
  EXPECT_GT(apart, 30);
  EXPECT_GT(together, 100);
}

TEST(ContactAtTheStart, TheSeparationItselfIsNoImpact) {
  const Polygon square = box(2, 2);
  for (const double error : kErrors) {
    const Motion passes = slide(0, 2 - 10 * 0.18, {0, 10});
    EXPECT_FALSE(timeOfImpact(square, still(0, 0), square, passes, within(error, true))) << error;
    EXPECT_TRUE(conflicts(square, still(0, 0), square, passes, within(error, true)).empty()) << error;
  }
}

/// A pose off rigid costs what an exact one costs, and its impact is where that one's is.
TEST(ContactAtTheStart, PosesOffRigid) {
  const Polygon post({rectangle(-0.25, -1, 0.25, 0)}), triangle({{{0, 0}, {1, 0.5}, {0.5, 1}}});
  Motion tips = still(0, 1e-9);
  tips.angle = -M_PI;
  const double exactly = timeOfImpact(post, still(0, 0), triangle, tips)->time;
  for (const double off : {4e-15, 1e-13, 1e-10, 1e-7, 4e-5})
    for (const bool shear : {false, true}) {
      Motion from = still(0, 0), tipped = tips;
      for (Motion* motion : {&from, &tipped})
        shear ? motion->start.linear()(0, 1) += off : motion->start.linear()(0, 0) *= 1 + off;
      const auto impact = timeOfImpact(post, from, triangle, tipped);
      ASSERT_TRUE(impact && !impact->budget_ended);
      EXPECT_NEAR(impact->time, exactly, 2 * off + 1e-6) << off << shear;
    }
  for (int i = 0; i < 200; ++i) {
    const Pose at = throughFloat(support::pose(0.03 * i, 0, 0));
    Motion motion = Motion::still(at);
    motion.start.translation() += at.linear() * Vec2(0, 1e-9);
    motion.angle = -M_PI;
    const auto impact = timeOfImpact(post, Motion::still(at), triangle, motion);
    ASSERT_TRUE(impact && !impact->budget_ended);
    EXPECT_NEAR(impact->time, exactly, 1e-5) << i;
  }
}

TEST(AbsentOutside, TheSamePlaceAtOtherTimes) {
  const Polygon robot = box(1, 1);
  const Trajectory first({{0, 10, still(0, 0)}}), second({{11, 20, still(0, 0)}}), longer({{5, 15, still(0.5, 0)}});
  EXPECT_EQ(conflicts(robot, first, robot, second).size(), 1u);  // they rest
  ImpactOptions absent;
  absent.absent_outside = true;
  EXPECT_TRUE(conflicts(robot, first, robot, second, absent).empty());
  EXPECT_FALSE(timeOfImpact(robot, first, robot, second, absent));
  expectOne(conflicts(robot, first, robot, longer, absent), 5, 10, 0);
  EXPECT_EQ(timeOfImpact(robot, first, robot, longer, absent)->time, 5);
}

}  // namespace
}  // namespace tricover::support
