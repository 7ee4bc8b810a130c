// SPDX-License-Identifier: BSD-3-Clause
// All spans of time in which two moving polygons meet, what met at the start left out, and trajectories of many legs.
#include "tricover/conflicts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "exact_reference.h"
#include "families.h"
#include "random.h"
#include "refusal.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/polygon.h"
#include "tricover/prepare.h"
#include "tricover/trajectory.h"

namespace tricover::support {
namespace {

constexpr double kError = 1e-4;

const Polygon kSquare({rectangle(-1, -1, 1, 1)});
const Polygon kWalls({rectangle(0, -5, 1, 5), rectangle(5, -5, 6, 5)});
const Motion kStill = Motion::still(turnedAndMoved(0, 0, 0));
const Motion kThrough = Motion::translation(turnedAndMoved(0, -10, 0), {20, 0});

void expectSpans(const std::vector<Conflict>& found, const std::vector<std::pair<double, double>>& spans,
                 double error = kError) {
  ASSERT_EQ(found.size(), spans.size());
  for (std::size_t i = 0; i < spans.size(); ++i) {
    EXPECT_LE(found[i].impact.time, spans[i].first + 1e-12);
    EXPECT_GE(found[i].impact.time, spans[i].first - error - 1e-12);
    EXPECT_GE(found[i].end, spans[i].second - 1e-12);
    EXPECT_LE(found[i].end, spans[i].second + error + 1e-12);
  }
}

TEST(Conflicts, AreAllSpansWithBeginAndEnd) {
  const std::vector<Conflict> found = conflicts(kWalls, kStill, kSquare, kThrough, {0, kError});
  expectSpans(found, {{0.45, 0.6}, {0.7, 0.85}});
  EXPECT_NEAR(found[1].impact.point.x(), 5, 1e-2);
  EXPECT_NEAR(found[1].impact.normal.x(), -1, 1e-9);
  expectSpans(conflicts(kSquare, kThrough, kWalls, kStill, {0, kError}), {{0.45, 0.6}, {0.7, 0.85}});
  expectSpans(conflicts(kWalls, kStill, kSquare, kThrough, {0.5, kError}), {{0.425, 0.625}, {0.675, 0.875}});
  expectSpans(conflicts(kWalls, kStill, kSquare, kThrough, {2, kError}), {{0.35, 0.95}});
  EXPECT_TRUE(conflicts(kWalls, kStill, kSquare, Motion::translation(turnedAndMoved(0, -10, 0), {0, 20})).empty());
}

/// Squares of lengths are 0 or infinite at most of these sizes.
TEST(Conflicts, OfAnySize) {
  std::vector<Conflict> truth;
  for (const double size : {1.0, 1e-300, 1e-170, 1e160, 1e300}) {
    SCOPED_TRACE(size);
    const Polygon walls = kWalls.scaled(size), square = kSquare.scaled(size);
    const auto from = [&](double x) { return turnedAndMoved(0, x * size, 0); };
    expectSpans(conflicts(walls, kStill, square, Motion::translation(from(-10), {20 * size, 0}), {0, kError}),
                {{0.45, 0.6}, {0.7, 0.85}});
    // From within the first wall, past the second one and back.
    Motion bends = Motion::translation(from(0), {30 * size, 0});
    bends.shift_2 = Vec2(-36, 3) * size;
    bends.shift_3 = Vec2(6, -3) * size;
    const ImpactOptions leaves{0, kError, true};
    const std::vector<Conflict> found = conflicts(walls, kStill, square, bends, leaves);
    if (truth.empty()) truth = found;
    expectSpans(found, {{truth[0].impact.time, truth[0].end}, {truth[1].impact.time, 1}}, 2 * kError);
    EXPECT_EQ(timeOfImpact(walls, kStill, square, bends, leaves)->time, found[0].impact.time);
  }
}

TEST(Conflicts, SayWhetherTheBodiesStillMeet) {
  for (const Conflict& passed : conflicts(kWalls, kStill, kSquare, kThrough, {0, kError}))
    EXPECT_FALSE(passed.meets_at_end);
  const std::vector<Conflict> stuck =
      conflicts(kWalls, kStill, kSquare, Motion::translation(turnedAndMoved(0, -10, 0), {10.5, 0}), {0, kError});
  ASSERT_EQ(stuck.size(), 1u);
  EXPECT_TRUE(stuck[0].meets_at_end && stuck[0].end == 1);
  // It leaves within the time error before the end.
  const std::vector<Conflict> left =
      conflicts(kWalls, kStill, kSquare, Motion::translation(turnedAndMoved(0, -10, 0), {12 + 1e-5, 0}), {0, kError});
  ASSERT_EQ(left.size(), 1u);
  EXPECT_FALSE(left[0].meets_at_end);
}

TEST(Conflicts, EndAtTheEnd) {
  expectSpans(conflicts(kSquare, kStill, kSquare, kStill), {{0, 1}}, 0);
  const Polygon beside({rectangle(1, -1, 3, 1)});
  expectSpans(conflicts(kSquare, kStill, beside, kStill), {{0, 1}}, 0);  // they touch, at rest
  expectSpans(conflicts(kSquare, kStill, kSquare, Motion::translation(turnedAndMoved(0, 4, 0), {-3, 0}), {0, kError}),
              {{2.0 / 3, 1}});
}

TEST(Conflicts, WhatMetAtTheStartIsIgnoredUntilItHasParted) {
  const Motion leaves = Motion::translation(turnedAndMoved(0, 0.5, 0), {20, 0});
  ImpactOptions options{0, kError};
  EXPECT_EQ(timeOfImpact(kWalls, kStill, kSquare, leaves, options)->time, 0);
  options.ignore_initial = true;
  const auto again = timeOfImpact(kWalls, kStill, kSquare, leaves, options);
  ASSERT_TRUE(again.has_value());
  EXPECT_NEAR(again->time, 0.175, kError);
  expectSpans(conflicts(kWalls, kStill, kSquare, leaves, options), {{0.175, 0.325}});
  EXPECT_FALSE(timeOfImpact(kWalls, kStill, kSquare, kStill, options).has_value());
  // It is as ever for what is apart at the start.
  EXPECT_NEAR(timeOfImpact(kWalls, kStill, kSquare, kThrough, options)->time, 0.45, kError);
}

TEST(Conflicts, AreTwoWhereWhatPartsThemLastsLongerThanTheTimeError) {
  Ring ring = {{-1, -1}, {1, -1}};  // with so many edges that boxes are searched
  for (int k = 0; k <= 40; ++k) ring.emplace_back(1 - 0.05 * k, k % 2 == 0 ? 1 : 0.9);
  const Polygon saw({ring});
  for (int i = 0; i < 40; ++i) {
    const double parted = kError * (1.05 + 0.05 * i), x = 0.37 * kError * i;
    const Polygon walls({rectangle(0, -5, 1, 5), rectangle(3 + 20 * parted, -5, 6, 5)});
    const Motion through = Motion::translation(turnedAndMoved(0, -10 + 20 * x, 0), {20, 0});
    EXPECT_EQ(conflicts(walls, kStill, saw, through, {0, kError}).size(), 2u) << i;
  }
}

TEST(MotionPart, IsTheMotionFromOneTimeToAnother) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    Motion motion = randomMotion(random, kSquare, 5);
    motion.shift_3 += Vec2(random.real(-9, 9), 4);
    const double from = random.real(0, 1), until = random.real(from, 1);
    const Motion part = motion.part(from, until);
    EXPECT_EQ(part.at(0).matrix(), motion.at(from).matrix());
    for (const double t : {0.25, 0.5, 1.0})
      EXPECT_TRUE(part.at(t).isApprox(motion.at(from + t * (until - from)), 1e-13));
  }
  EXPECT_EQ(refusal([] { kThrough.part(0, std::nan("")); }), "tricover: until: it is not finite; give a finite time");
}

TEST(Trajectory, GoesFromPoseToPoseAndRestsBeforeAndAfter) {
  const Trajectory way = Trajectory::through({{2, turnedAndMoved(0, 0, 0)},
                                              {4, turnedAndMoved(0, 4, 0)},
                                              {5, turnedAndMoved(0, 4, 0)},
                                              {6, turnedAndMoved(0, 4, 1)}});
  EXPECT_EQ(way.begin(), 2);
  EXPECT_EQ(way.end(), 6);
  EXPECT_EQ(way.at(0).translation(), Vec2(0, 0));
  EXPECT_EQ(way.at(3).translation(), Vec2(2, 0));
  EXPECT_EQ(way.at(4.5).translation(), Vec2(4, 0));
  EXPECT_EQ(way.at(5.5).translation(), Vec2(4, 0.5));
  EXPECT_EQ(way.at(9).translation(), Vec2(4, 1));
  EXPECT_EQ(way.part(2.5, 3).at(1).translation(), Vec2(2, 0));
  EXPECT_THROW(way.part(3, 5), std::invalid_argument);
  const Trajectory spline = Trajectory::spline({{0, {{0, 0}, 0, {1, 0}, 0}}, {10, {{10, 0}, 0, {1, 0}, 0}}});
  EXPECT_NEAR(spline.at(3).translation().x(), 3, 1e-12);  // a metre a second
}

TEST(Trajectory, RefusesTimesThatDontIncrease) {
  const std::vector<std::pair<std::vector<Leg>, const char*>> refused = {
      {{}, "tricover: legs: a trajectory needs at least one"},
      {{{0, 1, kStill}, {2, 3, kStill}}, "tricover: legs[1]: it must begin when the one before ends"},
      {{{1, 1, kStill}}, "tricover: legs[0]: it must end after its begin, both finite"}};
  for (const auto& [legs, message] : refused) EXPECT_EQ(refusal([&, &of = legs] { Trajectory{of}; }), message);
  EXPECT_EQ(refusal([] {
              Trajectory::through({{0, turnedAndMoved(0, 0, 0)}, {0, turnedAndMoved(0, 1, 0)}});
            }),
            "tricover: poses[1].time: times must be finite and increase");
}

TEST(Trajectory, RefusesPosesAndTimes) {
  Pose bent = turnedAndMoved(0, 1, 0), mirrored = turnedAndMoved(0, 2, 0);
  bent.linear()(0, 1) = 0.5;
  mirrored.linear().col(0) *= -1;
  const auto refusalOf = [](const Pose& second, const Pose& third) {
    return refusal([&] { Trajectory::through({{0, turnedAndMoved(0, 0, 0)}, {1, second}, {2, third}}); });
  };
  EXPECT_EQ(refusalOf(bent, turnedAndMoved(0, 2, 0)).find("tricover: poses[1].pose: linear() is off rigid by "), 0u);
  EXPECT_EQ(refusalOf(turnedAndMoved(0, 1, 0), bent).find("tricover: poses[2].pose: linear() is off rigid by "), 0u);
  EXPECT_EQ(
      refusalOf(turnedAndMoved(0, 1, 0), mirrored).find("tricover: poses[2].pose: only one of it and poses[1].pose "),
      0u);
  const Trajectory way = Trajectory::through({{0, turnedAndMoved(0, 0, 0)}, {1, turnedAndMoved(0, 1, 0)}});
  EXPECT_EQ(refusal([&] { way.at(std::nan("")); }).find("tricover: time: it is not a number"), 0u);
  for (const bool late : {false, true}) EXPECT_EQ(way.at(late ? HUGE_VAL : -HUGE_VAL).translation(), Vec2(late, 0));
}

TEST(Trajectory, ConflictsGoOnFromLegToLegInTheClocksTime) {
  // Into the first wall, a wait there, and on through both.
  const Trajectory way = Trajectory::through({{10, turnedAndMoved(0, -10, 0)},
                                              {20, turnedAndMoved(0, 0, 0)},
                                              {30, turnedAndMoved(0, 0, 0)},
                                              {40, turnedAndMoved(0, 10, 0)}});
  const Trajectory rests({{0, 100, kStill}});
  const double error = 1e-3;
  expectSpans(conflicts(kWalls, rests, kSquare, way, {0, error}), {{19, 32}, {34, 37}}, error);
  const auto first = timeOfImpact(kWalls, rests, kSquare, way, {0, error});
  ASSERT_TRUE(first.has_value());
  EXPECT_LE(first->time, 19);
  EXPECT_GE(first->time, 19 - error);
  // The other one's clock ends sooner, in the wall.
  const Trajectory from_inside({{25, 35, Motion::translation(turnedAndMoved(0, 0.5, 0), {20, 0})}});
  ImpactOptions options{0, error, true};
  expectSpans(conflicts(kWalls, rests, kSquare, from_inside, options), {{26.75, 28.25}}, error);
  EXPECT_NEAR(timeOfImpact(kWalls, rests, kSquare, from_inside, options)->time, 26.75, error);
}

/// With inner discs there are other certificates of overlap.
TEST(Conflicts, DontDependOnWhatWasAskedBefore) {
  Random random(5);
  int found = 0;
  for (const Family& family : familiesOfAllSizes())
    for (int seed = 0; seed < scaledCount(150); ++seed) {
      SCOPED_TRACE(family.name + std::to_string(seed));
      const Case c = family.make(static_cast<std::uint64_t>(seed));
      Motion passes = Motion::still(c.pose_b);
      passes.shift = 4 * c.a.radius() * Vec2(random.real(-1, 1), random.real(-1, 1));
      passes.angle = random.real(-2, 2);
      const auto ask = [&, error = random.real(3e-4, 1e-3)] {
        std::vector<double> times;
        for (const Conflict& conflict : conflicts(c.a, Motion::still(c.pose_a), c.b, passes, {0, error}))
          times.insert(times.end(), {conflict.impact.time, conflict.end});
        return times;
      };
      const std::vector<double> first = ask();
      prepare(c.a);
      prepare(c.b);
      EXPECT_EQ(ask(), first);
      found += static_cast<int>(first.size()) / 2;
    }
  if (!isScaledDown()) {
    EXPECT_GT(found, 1000);
  }
}

}  // namespace
}  // namespace tricover::support
