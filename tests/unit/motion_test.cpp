// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/motion.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "random.h"
#include "refusal.h"
#include "shapes.h"
#include "tricover/trajectory.h"

namespace tricover::support {
namespace {

constexpr double kPi = 3.14159265358979323846;

TEST(Motion, KeepsWhatIsWritten) {
  EXPECT_EQ(Motion::still(turnedAndMoved(0.3, 1, 2)).at(0.7).matrix(), turnedAndMoved(0.3, 1, 2).matrix());
  const Motion motion = Motion::translation(throughFloat(turnedAndMoved(0.3, 1, 2)), {4, -8});
  EXPECT_EQ(motion.at(0.25).linear(), motion.start.linear());
  EXPECT_EQ(motion.at(0.5).translation(), Vec2(motion.start.translation() + Vec2(2, -4)));
  const Motion between = Motion::between(throughFloat(turnedAndMoved(0.3, 1e15, 2)), turnedAndMoved(2, 3, 4), {5, 6});
  EXPECT_EQ(between.at(0).matrix(), between.start.matrix());
}

TEST(Motion, TurnsAboutThePivotWhileThatMovesStraight) {
  Motion motion;
  motion.start = turnedAndMoved(kPi / 2, 10, 0);
  motion.pivot = {2, 0};  // at (10, 2) in the world
  motion.shift = {0, 8};
  motion.angle = kPi;
  const Pose half = motion.at(0.5);
  EXPECT_NEAR((half * Vec2(2, 0) - Vec2(10, 6)).norm(), 0, 1e-14);
  // The frame's origin was below the pivot and is now, a quarter turn counter-clockwise, on its right.
  EXPECT_NEAR((half * Vec2(0, 0) - Vec2(12, 6)).norm(), 0, 1e-14);
}

TEST(Motion, TurnsCounterClockwiseInTheWorldThoughMirrored) {
  Motion motion;
  motion.start = mirrored(turnedAndMoved(0, 0, 0));
  motion.angle = kPi / 2;
  EXPECT_NEAR((motion.at(1) * Vec2(1, 0) - Vec2(0, 1)).norm(), 0, 1e-15);
  EXPECT_NEAR((motion.at(1) * Vec2(0, 1) - Vec2(1, 0)).norm(), 0, 1e-15);
}

TEST(Motion, KeepsThePivotToRoundingThroughManyTurns) {
  Motion motion;
  motion.start = turnedAndMoved(1, 2, 3);
  motion.pivot = {4, 5};
  motion.angle = 2e4 * kPi;
  const Vec2 pivot = motion.start * motion.pivot;
  for (double time = 0; time <= 1; time += 0.01) ASSERT_NEAR((motion.at(time) * motion.pivot - pivot).norm(), 0, 1e-14);
}

TEST(Motion, BetweenEndsAtItsEnd) {
  Random random(7);
  for (int i = 0; i < 2000; ++i) {
    Pose start = randomPose(random, 10), end = randomPose(random, 10);
    if (i % 3 == 0) start = mirrored(start), end = mirrored(end);
    const Vec2 pivot(random.real(-5, 5), random.real(-5, 5));
    const Motion motion = Motion::between(start, end, pivot);
    ASSERT_GT(motion.angle, -kPi);
    ASSERT_LE(motion.angle, kPi);
    ASSERT_LT((motion.at(1).matrix() - end.matrix()).norm(), 1e-13);
    // The pivot is on the straight line.
    const Vec2 there = 0.75 * (start * pivot) + 0.25 * (end * pivot);
    ASSERT_LT((motion.at(0.25) * pivot - there).norm(), 1e-13);
  }
}

TEST(Motion, BetweenTurnsByPiRatherThanMinusPi) {
  Pose half = Pose::Identity();
  half.linear() << -1, -0.0, 0.0, -1;
  EXPECT_EQ(Motion::between(Pose::Identity(), half).angle, kPi);
  half.linear() << -1, 0.0, -0.0, -1;
  EXPECT_EQ(Motion::between(Pose::Identity(), half).angle, kPi);
}

TEST(Motion, SplineGoesFromEndToEndAtTheGivenVelocities) {
  Random random(11);
  for (int i = 0; i < 500; ++i) {
    const auto vector = [&] { return Vec2(random.real(-5, 5), random.real(-5, 5)); };
    const SplineEnd begin{vector(), random.real(-9, 9), vector(), random.real(-9, 9)};
    const SplineEnd end{vector(), random.real(-9, 9), vector(), random.real(-9, 9)};
    const Vec2 pivot = vector();
    const Motion motion = Motion::spline(begin, end, pivot);
    constexpr double kStep = 1e-6;
    const auto velocity = [&](double t) { return Vec2((motion.at(t + kStep) * pivot - motion.at(t) * pivot) / kStep); };
    const auto turned = [&](double from, double to) {
      const Eigen::Matrix2d turn = motion.at(to).linear() * motion.at(from).linear().transpose();
      return std::atan2(turn(1, 0), turn(0, 0));
    };
    ASSERT_LT((motion.start * pivot - begin.position).norm(), 1e-14);
    ASSERT_LT((motion.at(1) * pivot - end.position).norm(), 1e-13);
    ASSERT_LT((motion.at(1).linear() - Eigen::Rotation2Dd(end.angle).toRotationMatrix()).norm(), 1e-13);
    ASSERT_LT((velocity(0) - begin.velocity).norm(), 1e-3);
    ASSERT_LT((velocity(1 - kStep) - end.velocity).norm(), 1e-3);
    ASSERT_NEAR(turned(0, kStep) / kStep, begin.angular_velocity, 1e-3);
    ASSERT_NEAR(turned(1 - kStep, 1) / kStep, end.angular_velocity, 1e-3);
  }
}

TEST(Motion, SplineOfControlPointsIsTheUniformCubicBSpline) {
  Random random(12);
  for (int i = 0; i < 500; ++i) {
    std::array<Vec2, 4> p;
    std::array<double, 4> angle;
    for (std::size_t k = 0; k < 4; ++k) {
      p[k] = Vec2(random.real(-5, 5), random.real(-5, 5));
      angle[k] = random.real(-9, 9);
    }
    const Motion motion = Motion::spline(p, angle);
    for (const double t : {0.0, 0.2, 0.5, 0.9, 1.0}) {
      const double weights[] = {(1 - t) * (1 - t) * (1 - t) / 6, (3 * t * t * t - 6 * t * t + 4) / 6,
                                (-3 * t * t * t + 3 * t * t + 3 * t + 1) / 6, t * t * t / 6};
      Vec2 position = Vec2::Zero();
      double turn = 0;
      for (std::size_t k = 0; k < 4; ++k) position += weights[k] * p[k], turn += weights[k] * angle[k];
      ASSERT_LT((motion.at(t).translation() - position).norm(), 1e-14);
      ASSERT_LT((motion.at(t).linear() - Eigen::Rotation2Dd(turn).toRotationMatrix()).norm(), 1e-13);
    }
  }
}

TEST(Motion, ASplineRestsAtItsKnotsExactly) {
  const Vec2 pivot(0.3, -0.7);
  const TimedKnot first{1, {{0.1, 0.2}, kPi / 2, {3, 1}, 0.5}}, last{4, {{7.7, -0.3}, -kPi, {0, 2}, -1}};
  const Trajectory spline = Trajectory::spline({first, {2, {{3, 1}, 1, {1, 1}, 1}}, last}, pivot);
  for (const TimedKnot& knot : {first, last}) {
    const Pose at = spline.at(knot.time);
    EXPECT_EQ(at.linear(), poseAt(0, 0, knot.end.angle).linear());
    EXPECT_EQ(at.translation(), knot.end.position - at.linear() * pivot);
    EXPECT_EQ(std::abs(at.linear()(0, 0)) + std::abs(at.linear()(0, 1)), 1);  // exact quarter turns
  }
  EXPECT_EQ(spline.at(9).matrix(), spline.at(4).matrix());
}

TEST(Motion, BetweenRefusesAMirror) {
  EXPECT_NE(refusal([] { Motion::between(Pose::Identity(), mirrored(Pose::Identity())); }).find("tricover: end: "),
            std::string::npos);
}

TEST(Motion, HasNoPoseAtATimeThatIsNotFinite) {
  for (const double time : {std::nan(""), HUGE_VAL, -HUGE_VAL})
    for (const Motion& motion : {Motion::still(Pose::Identity()), Motion::translation(Pose::Identity(), {1, 0})})
      EXPECT_EQ(refusal([&] { motion.at(time); }), "tricover: time: it is not finite; give a finite time");
}

TEST(CheckMotion, NamesTheField) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();
  const auto refusalOf = [](const Motion& motion) { return refusal([&] { checkMotion(motion, "motion_b"); }); };
  EXPECT_EQ(refusalOf(Motion()), "");
  const std::pair<const char*, void (*)(Motion&)> breaks[] = {
      {"angle", [](Motion& m) { m.angle = kInf; }},         {"shift", [](Motion& m) { m.shift.y() = kNan; }},
      {"pivot", [](Motion& m) { m.pivot.x() = -kInf; }},    {"shift_2", [](Motion& m) { m.shift_2.x() = kInf; }},
      {"shift_3", [](Motion& m) { m.shift_3.y() = kNan; }}, {"angle_2", [](Motion& m) { m.angle_2 = kNan; }},
      {"angle_3", [](Motion& m) { m.angle_3 = -kInf; }},    {"start", [](Motion& m) { m.start.linear() *= 1.1; }}};
  for (const auto& [field, spoil] : breaks) {
    Motion motion;
    spoil(motion);
    EXPECT_EQ(refusalOf(motion).find(std::string("tricover: motion_b.") + field + ": "), 0U) << refusalOf(motion);
  }
}

}  // namespace
}  // namespace tricover::support
