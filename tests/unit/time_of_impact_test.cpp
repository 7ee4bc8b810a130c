// SPDX-License-Identifier: BSD-3-Clause
// Impacts whose times are known by hand.
#include "tricover/time_of_impact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "random.h"
#include "refusal.h"
#include "shapes.h"
#include "tricover/collide.h"
#include "tricover/segment.h"

namespace tricover::support {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kTimeError = ImpactOptions().time_error;
/// Of a time whose motion is of about the polygons' size: rounding.
constexpr double kRounding = 1e-12;

Motion turning(const Pose& start, double angle, const Vec2& shift = Vec2::Zero(), const Vec2& pivot = Vec2::Zero()) {
  Motion motion;
  motion.start = start;
  motion.angle = angle;
  motion.shift = shift;
  motion.pivot = pivot;
  return motion;
}

/// The impact is there, never later than `truth` and not too early; swapped operands say the same.
Impact expectImpact(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b, double truth,
                    double rounding = kRounding, const ImpactOptions& options = {}) {
  const auto impact = timeOfImpact(a, motion_a, b, motion_b, options),
             swapped = timeOfImpact(b, motion_b, a, motion_a, options);
  if (!impact || !swapped) {
    ADD_FAILURE() << "no impact, expected at " << truth;
    return {};
  }
  EXPECT_LE(impact->time, truth + 1e-16);
  EXPECT_GE(impact->time, truth - kTimeError - rounding);
  EXPECT_NEAR(impact->normal.norm(), 1, 1e-12);
  EXPECT_EQ(impact->time, swapped->time);
  EXPECT_EQ(impact->normal, Vec2(-swapped->normal));
  EXPECT_EQ(impact->point, swapped->point);
  EXPECT_EQ(impact->edge_a, swapped->edge_b);
  EXPECT_EQ(impact->edge_b, swapped->edge_a);
  return *impact;
}

void expectFree(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b) {
  EXPECT_FALSE(timeOfImpact(a, motion_a, b, motion_b).has_value());
  EXPECT_FALSE(timeOfImpact(b, motion_b, a, motion_a).has_value());
}

const Motion kStill;

/// Whichever is far away, nothing overflows on the way to the pair's own length.
TEST(TimeOfImpact, OfAPairAtRestFarApartIsNone) {
  const Polygon large({rectangle(-2, -2, 2, 2)}), small({rectangle(-1, -1, 1, 1)});
  for (const Vec2& far : {Vec2(1e12, 0), Vec2(0, -1e200), Vec2(1e300, 1e300)}) {
    expectFree(large, kStill, small, Motion::still(turnedAndMoved(0, far.x(), far.y())));
    expectFree(large, Motion::still(turnedAndMoved(0, far.x(), far.y())), small, kStill);
  }
}

TEST(TimeOfImpact, SquareMeetsWall) {
  const Polygon square({rectangle(0, 0, 1, 1)}), wall({rectangle(3, -10, 4, 10)});
  const Impact impact = expectImpact(square, Motion::translation(Pose::Identity(), {8, 0}), wall, kStill, 0.25);
  EXPECT_NEAR((impact.normal - Vec2(1, 0)).norm(), 0, 1e-7);
  EXPECT_NEAR(impact.point.x(), 3, 1e-5);
  EXPECT_GE(impact.point.y(), 0);
  EXPECT_LE(impact.point.y(), 1);
  EXPECT_EQ(impact.edge_b, 3);
}

TEST(TimeOfImpact, CornerMeetsWall) {
  const Polygon square({rectangle(-1, -1, 1, 1)}), wall({rectangle(3, -10, 4, 10)});
  const Impact impact = expectImpact(square, Motion::translation(turnedAndMoved(kPi / 4, 0, 0.5), {2, 0}), wall, kStill,
                                     (3 - std::sqrt(2)) / 2);
  EXPECT_NEAR((impact.normal - Vec2(1, 0)).norm(), 0, 1e-7);
  EXPECT_NEAR((impact.point - Vec2(3, 0.5)).norm(), 0, 1e-5);
  EXPECT_EQ(impact.edge_b, 3);
}

/// 1e-3 through 1e-3 in a step of 1e3.
TEST(TimeOfImpact, BulletDoesNotTunnel) {
  const Polygon bullet({rectangle(-5e-4, -5e-4, 5e-4, 5e-4)}), wall({rectangle(-5e-4, -50, 5e-4, 50)});
  for (const double angle : {0.0, 40.0}) {
    const auto impact = timeOfImpact(bullet, turning(turnedAndMoved(0, -500, 0.3), angle, {1000, 0}), wall, kStill);
    ASSERT_TRUE(impact);
    EXPECT_LE(impact->time, 0.5 - 0.9e-6);
    EXPECT_GE(impact->time, 0.5 - 2.3e-6);
  }
}

/// A rod from the origin along +x, 0.2 thick, of length 2, against a thin post straight ahead at angle 340 degrees.
TEST(TimeOfImpact, RodTurns350Degrees) {
  const Polygon rod({rectangle(0, -0.1, 2, 0.1)});
  const double post_angle = 340 * kPi / 180;
  // A small square whose corner is at distance 1.5 and points back along the turn.
  const Polygon post({{{0, 0}, {0.05, 0.05}, {0.05, -0.05}}});
  const Pose at_post = turnedAndMoved(post_angle + kPi / 2, 1.5 * std::cos(post_angle), 1.5 * std::sin(post_angle));
  // The rod's upper side passes through the corner where it is 0.1 ahead of its middle line.
  const double met = post_angle - std::asin(0.1 / 1.5), way = 350 * kPi / 180;
  const Impact impact = expectImpact(rod, turning(Pose::Identity(), way), post, Motion::still(at_post), met / way);
  EXPECT_NEAR((impact.point - at_post.translation()).norm(), 0, 2e-5);
  EXPECT_EQ(impact.edge_a, 2);
  const Vec2 ahead(-std::sin(met), std::cos(met));
  EXPECT_NEAR((impact.normal - ahead).norm(), 0, 2e-5);
  // The other way round it is met after 20 degrees less.
  expectImpact(rod, turning(Pose::Identity(), -way), post, Motion::still(at_post),
               (2 * kPi - post_angle - std::asin(0.1 / 1.5)) / way, 0.1);
}

TEST(TimeOfImpact, RodBetweenPostsIsFree) {
  const Polygon rod({rectangle(0, -0.1, 2, 0.1)}), post({rectangle(-0.05, -0.05, 0.05, 0.05)});
  expectFree(rod, turning(Pose::Identity(), 350 * kPi / 180), post, Motion::still(turnedAndMoved(0, 2.06, 0.0)));
  // From 0.3 to 20 degrees before that, the post in the middle of the rest.
  expectFree(rod, turning(turnedAndMoved(0.3, 0, 0), 340 * kPi / 180), post,
             Motion::still(turnedAndMoved(0.1255, 1.5 * std::cos(0.1255), 1.5 * std::sin(0.1255))));
}

TEST(TimeOfImpact, GrazeIsContactAndAHairAsideIsFree) {
  const Polygon square({rectangle(0, 0, 1, 1)});
  const Motion still = Motion::still(turnedAndMoved(0, 5, 1));
  expectImpact(square, Motion::translation(Pose::Identity(), {10, 0}), square, still, 0.4);
  expectFree(square, Motion::translation(turnedAndMoved(0, 0, -1e-9), {10, 0}), square, still);
  // A vertex that brushes a vertex.
  const Polygon tip({{{0, 1}, {-1, 0}, {1, 0}}}), down({{{0, 1}, {1, 2}, {-1, 2}}});
  expectImpact(tip, Motion::translation(turnedAndMoved(0, -4, 0), {8, 0}), down, kStill, 0.5);
  expectFree(tip, Motion::translation(turnedAndMoved(0, -4, -1e-9), {8, 0}), down, kStill);
  // A turning tip that brushes a wall at the top of its circle.
  const Polygon wall({rectangle(-9, 1, 9, 2)});
  expectImpact(tip, turning(turnedAndMoved(-1, 0, 0), 2), wall, kStill, 0.5, 1e-6);
  expectFree(tip, turning(turnedAndMoved(-1, 0, 0), 2), wall, Motion::still(turnedAndMoved(0, 0, 1e-9)));
}

TEST(TimeOfImpact, ContactAtTheEndCounts) {
  const Polygon square({rectangle(0, 0, 1, 1)});
  expectImpact(square, Motion::translation(Pose::Identity(), {4, 0}), square, Motion::still(turnedAndMoved(0, 5, 0.5)),
               1);
  expectFree(square, Motion::translation(Pose::Identity(), {4 - 1e-9, 0}), square,
             Motion::still(turnedAndMoved(0, 5, 0.5)));
}

TEST(TimeOfImpact, OverlapAtTheStartIsTimeZero) {
  const Polygon square({rectangle(0, 0, 1, 1)}), large({rectangle(-5, -5, 6, 6)});
  // Parting from a touch.
  const Impact touch = expectImpact(square, kStill, square, Motion::translation(turnedAndMoved(0, 1, 0), {1, 0}), 0);
  EXPECT_EQ(touch.time, 0);
  EXPECT_EQ(touch.normal, Vec2(1, 0));
  EXPECT_EQ(touch.point.x(), 1);
  // Held inside, no edges meeting.
  const Impact held = expectImpact(square, turning(Pose::Identity(), 3), large, kStill, 0);
  EXPECT_EQ(held.time, 0);
  EXPECT_EQ(held.point, Vec2(0, 0));
  EXPECT_EQ(held.edge_a, 0);
  EXPECT_EQ(held.edge_b, -1);
  EXPECT_EQ(expectImpact(square, kStill, square, Motion::still(turnedAndMoved(0.2, 0.5, 0)), 0).time, 0);
}

/// collide() at the start <=> time 0, though rounding can't tell these from a touch.
TEST(TimeOfImpact, AnUlpApartIsNotTimeZero) {
  const Polygon square({rectangle(0, 0, 1, 1)});
  for (const double x : {nudged(1, 1), nudged(-1, -1)}) {
    const auto impact = timeOfImpact(square, kStill, square, Motion::translation(turnedAndMoved(0, x, 0), {-x, 0}));
    ASSERT_TRUE(impact);
    EXPECT_GT(impact->time, 0);
    EXPECT_LT(impact->time, 1e-15);
    EXPECT_EQ(impact->normal, Vec2(x > 0 ? 1 : -1, 0));
  }
}

TEST(TimeOfImpact, StillAndApartIsFree) {
  const Polygon square({rectangle(0, 0, 1, 1)}), c({{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {4, 3}, {4, 4}, {0, 4}}});
  expectFree(c, kStill, square, Motion::still(turnedAndMoved(0, 2, 1.5)));
}

/// A box with a gap of 1 in its right wall.
TEST(TimeOfImpact, LeavesThroughAGap) {
  const Polygon room(
      {{{0, 0}, {10, 0}, {10, 4.5}, {9, 4.5}, {9, 1}, {1, 1}, {1, 9}, {9, 9}, {9, 5.5}, {10, 5.5}, {10, 10}, {0, 10}}});
  const Polygon ball({regular(16, 0.45)});
  expectFree(room, kStill, ball, Motion::translation(turnedAndMoved(0, 5, 5), {20, 0}));
  expectFree(room, kStill, ball, turning(turnedAndMoved(0, 5, 5), 50, {20, 0}));
  expectImpact(room, kStill, ball, Motion::translation(turnedAndMoved(0, 5, 3), {16, 0}), (9 - 0.45 - 5) / 16);
}

TEST(TimeOfImpact, HoleHoldsTheBall) {
  const Polygon frame({rectangle(-10, -10, 10, 10), rectangle(-5, -5, 5, 5)}), ball({regular(16, 1)});
  expectImpact(frame, kStill, ball, Motion::translation(Pose::Identity(), {0, 40}), 0.1);
  expectFree(frame, kStill, ball, Motion::translation(Pose::Identity(), {0, 3.9}));
}

TEST(TimeOfImpact, OrbitsInAnAnnulus) {
  const Polygon annulus({regular(64, 12), regular(64, 10), regular(64, 5)}), ball({regular(12, 2)});
  // Three turns about the common centre, 7.5 away.
  expectFree(annulus, kStill, ball, turning(turnedAndMoved(0, 7.5, 0), 6 * kPi, Vec2::Zero(), {-7.5, 0}));
  // The annulus turns the other way.
  expectFree(annulus, turning(Pose::Identity(), -20), ball,
             turning(turnedAndMoved(0, 7.5, 0), 6 * kPi, Vec2::Zero(), {-7.5, 0}));
  // Spirals out.
  EXPECT_TRUE(timeOfImpact(annulus, kStill, ball, turning(turnedAndMoved(0, 7.5, 0), 6 * kPi, {2, 0}, {-7.5, 0})));
}

/// Two rods that turn against each other like gears, about pivots 3 apart: both reach 1.75, and their tips meet where
/// both point at the other pivot. a takes an eighth of a turn to get there, then every half turn; b as well.
TEST(TimeOfImpact, BothTurn) {
  const Polygon rod({{{-1.75, 0}, {0, -0.01}, {1.75, 0}, {0, 0.01}}});
  const double angle = 4 * kPi;
  const auto impact = timeOfImpact(rod, turning(turnedAndMoved(-kPi / 4, 0, 0), angle), rod,
                                   turning(turnedAndMoved(kPi / 4, 3, 0), -angle));
  ASSERT_TRUE(impact);
  // Tips at distance 1.75: they cross before they are in line, where both are at the same height.
  const double met = (kPi / 4 - std::acos(1.5 / 1.75)) / angle;
  EXPECT_LE(impact->time, met);
  EXPECT_GE(impact->time, met - 2e-3 / angle - kTimeError);
  // A quarter turn apart they mesh.
  expectFree(rod, turning(Pose::Identity(), angle), rod, turning(turnedAndMoved(kPi / 2, 3, 0), -angle));
}

/// Side by side on one turntable: edges on one line, none of which meet, and nothing moves against anything.
TEST(TimeOfImpact, TurningTogetherIsFree) {
  const Polygon square({rectangle(0, 0, 1, 1)});
  for (const double gap : {1e-2, 1e-4, 1e-6, 1e-9, 1e-12})
    expectFree(square, turning(Pose::Identity(), kPi), square,
               turning(turnedAndMoved(0, 1 + gap, 0), kPi, Vec2::Zero(), {-1 - gap, 0}));
}

/// Bodies that stand on a point close to the floor and tip about it, or slide along it, faster and faster: near the
/// point nothing comes nearer, however long that takes to see. (This one hung: tipping and sliding, 1e-9 above.)
TEST(TimeOfImpact, OfWhatMovesAlongCloseToAnother) {
  const Polygon floor({rectangle(-9, -2, 9, 0)}), triangle({{{0, 0}, {1, 1}, {-0.5, 1}}});
  Ring bent = {{0, 0}};  // twenty vertices and two, strictly convex
  for (int i = 0; i < 10; ++i) bent.emplace_back(0.02 + 1e-3 * i * (9 - i), 0.1 + 0.1 * i);
  bent.emplace_back(0, 1.1);
  for (int i = 10; i-- > 0;) bent.emplace_back(-0.02 - 1e-3 * i * (9 - i), 0.1 + 0.1 * i);
  const Polygon rod({bent}), notched({{{0, 0}, {0.02, 0.3}, {0.01, 0.5}, {0.02, 0.7}, {0, 1.1}, {-0.02, 0.7}}});
  const double corner = std::hypot(0.5, 1), up = kPi - std::atan2(1, -0.5) - 0.1;
  for (const double gap : {1e-3, 1e-6, 1e-9, 1e-12})
    for (const double time_error : {1e-3, 1e-6, 1e-12})
      for (const bool speeds_up : {false, true}) {
        Motion slides = Motion::still(turnedAndMoved(0.1, 0.3, gap));
        slides.shift = Vec2(0.5, 0);
        if (speeds_up) slides.shift_2 = Vec2(1, 0);
        Motion tips = slides;
        tips.angle = 1.2;
        const ImpactOptions options{0, time_error};
        for (const Polygon& body : {triangle, rod, notched}) {
          EXPECT_FALSE(timeOfImpact(floor, kStill, body, slides, options)) << gap;
          const auto tipped = timeOfImpact(floor, kStill, body, tips, options);
          EXPECT_EQ(tipped.has_value(), body.id() == triangle.id()) << gap;
        }
        const auto impact = timeOfImpact(floor, kStill, triangle, tips, options);
        ASSERT_TRUE(impact);
        const double met = (up + std::asin(gap / corner)) / 1.2;
        EXPECT_LE(impact->time, met + 1e-12);
        EXPECT_GE(impact->time, met - time_error - 1e-12);
      }
}

TEST(TimeOfImpact, MirroredTurnsCounterClockwise) {
  // An arm that points down in its own frame and up in the world.
  const Polygon arm({{{0, 0}, {-0.1, -2}, {0.1, -2}}}), wall({rectangle(-3, -3, -1.5, 3)});
  Pose flipped = Pose::Identity();
  flipped.linear()(1, 1) = -1;
  // The corner (-0.1, 2) is at the angle pi / 2 + e, and meets x = -1.5 at acos(-1.5 / r).
  const double r = std::hypot(0.1, 2.0), e = std::atan2(0.1, 2.0);
  expectImpact(arm, turning(flipped, 1.5), wall, kStill, (std::acos(-1.5 / r) - kPi / 2 - e) / 1.5);
  expectFree(arm, turning(flipped, -1.5), wall, kStill);
}

TEST(TimeOfImpact, AtAnyScale) {
  for (const double scale : {1e-300, 1e-150, 1e-9, 1e9, 1e150, 1e300}) {
    const Polygon square({scaled(rectangle(0, 0, 1, 1), scale)}), wall({scaled(rectangle(3, -10, 4, 10), scale)});
    const Pose turned = turnedAndMoved(0, 0, 0);
    expectImpact(square, Motion::translation(turned, Vec2(8, 0) * scale), wall, kStill, 0.25);
    expectFree(square, Motion::translation(turned, Vec2(0, 8) * scale), wall, kStill);
    const Polygon rod({scaled(rectangle(0, -1, 4, 1), scale)});
    // The corner (4, 1) comes from above to the wall's top (3, -10) .. only where the wall is: meets x = 3 at
    // acos(3/r).
    const double r = std::hypot(4.0, 1.0), met = std::acos(3 / r) + std::atan2(1.0, 4.0);
    expectImpact(rod, turning(turnedAndMoved(kPi / 2, 0, 0), -2), wall, kStill,
                 (kPi / 2 - met + 2 * std::atan2(1.0, 4.0)) / 2, 1);
  }
}

TEST(TimeOfImpact, TinyAndHugeTogether) {
  const Polygon bullet({scaled(rectangle(-1, -1, 1, 1), 1e-200)}), wall({scaled(rectangle(0, -1, 1, 1), 1e100)});
  expectImpact(bullet, Motion::translation(turnedAndMoved(0, -1e100, 0), {1e101, 0}), wall, kStill, 0.1);
  expectFree(bullet, Motion::translation(turnedAndMoved(0, -1e100, 0), {0, 1e101}), wall, kStill);
  // Near the largest double nothing is proven to be apart, but what is far away.
  const Polygon huge({scaled(rectangle(-1, -1, 1, 1), 1e308)});
  EXPECT_TRUE(timeOfImpact(huge, turning(turnedAndMoved(0.3, -1e308, 1e308), 3, {1e308, 1e308}), huge, kStill));
}

TEST(TimeOfImpact, FarFromTheOrigin) {
  const Polygon square({rectangle(0, 0, 1, 1)});
  const Pose here = turnedAndMoved(0, 1e15, -1e15), there = turnedAndMoved(0, 1e15 + 3, -1e15);
  expectImpact(square, Motion::translation(here, {4, 0}), square, Motion::still(there), 0.5);
  const Impact impact = expectImpact(square, turning(here, 0, {4, 0}), square, Motion::still(there), 0.5);
  EXPECT_EQ(impact.point.x(), 1e15 + 3);
}

TEST(TimeOfImpact, TurnsWithoutEnd) {
  // Whatever the number of turns, what is out of reach is free and what isn't is met.
  const Polygon rod({rectangle(-2, -0.1, 2, 0.1)}), post({rectangle(-0.05, -0.05, 0.05, 0.05)});
  for (const double angle : {1e3, 1e6, 1e200, -1e308}) {
    EXPECT_TRUE(timeOfImpact(rod, turning(Pose::Identity(), angle), post, Motion::still(turnedAndMoved(0, 0, 1))));
    expectFree(rod, turning(Pose::Identity(), angle), post, Motion::still(turnedAndMoved(0, 0, 2.2)));
  }
}

TEST(TimeOfImpact, CubicWayMeetsTheWallWhenItsCubicDoes) {
  const Polygon square({rectangle(0, 0, 1, 1)}), wall({rectangle(3, -10, 4, 10)});
  Motion motion;
  motion.shift_3 = {16, 0};  // 16 t^3 = 2
  expectImpact(square, motion, wall, kStill, 0.5);
  motion.shift_3 = {0, 0};
  motion.shift_2 = {8, 0};  // 8 t^2 = 2
  expectImpact(square, motion, wall, kStill, 0.5);
  motion.shift = {-4, 0};  // back first: 12 t^2 - 4 t = 2
  motion.shift_2 = {12, 0};
  expectImpact(square, motion, wall, kStill, (4 + std::sqrt(16.0 + 96)) / 24);
  // There and back again: 8 t - 8 t^2 is 2 at most, at t = 1/2.
  motion.shift = {8, 0};
  motion.shift_2 = {-8, 0};
  expectImpact(square, motion, wall, kStill, 0.5, 1e-5);
  motion.shift.x() = std::nextafter(8, 0) - 1e-9;
  expectFree(square, motion, wall, kStill);
}

TEST(TimeOfImpact, TwoOnTheSameSplineAreFreeThoughBothTurn) {
  const Polygon left({rectangle(-2, -1, -1, 1)}), right({rectangle(1, -1, 2, 1)});
  const Motion motion = Motion::spline({{0, 0}, 0, {50, 0}, 9}, {{10, 10}, 20, {0, 70}, -5});
  expectFree(left, motion, right, motion);
}

TEST(TimeOfImpact, TurnsThatSpeedUp) {
  // A rod that is upright after a quarter turn, at 4 t^3 = 1.
  const Polygon rod({rectangle(-4, -0.001, 4, 0.001)}), post({rectangle(-0.001, 3, 0.001, 3.5)});
  Motion motion;
  motion.angle_3 = 2 * kPi;
  const double early = 0.002 / 3.5 / (2 * kPi);
  expectImpact(rod, motion, post, kStill, std::cbrt(0.25), 2 * early);
}

TEST(TimeOfImpact, MarginIsMetSoonerByAsMuch) {
  const Polygon square({rectangle(0, 0, 1, 1)}), wall({rectangle(3, -10, 4, 10)});
  const Motion motion = Motion::translation(Pose::Identity(), {8, 0});
  ImpactOptions options;
  options.margin = 0.5;
  const Impact impact = expectImpact(square, motion, wall, kStill, 1.5 / 8, kRounding, options);
  EXPECT_NEAR((impact.normal - Vec2(1, 0)).norm(), 0, 1e-7);
  EXPECT_NEAR(impact.point.x(), 2.75, 1e-5);
  options.margin = 2;  // as near as that from the beginning
  EXPECT_EQ(expectImpact(square, motion, wall, kStill, 0, kRounding, options).time, 0);
  options.margin = std::nextafter(2, 0);
  EXPECT_GT(timeOfImpact(square, motion, wall, kStill, options)->time, 0);
  // Past a corner: a graze of the margin's disc around it.
  const Polygon point({{{0, 0}, {0, 0}, {0, 0}}}), corner({rectangle(5, 3, 6, 4)});
  options.margin = 3;
  EXPECT_NEAR(timeOfImpact(point, Motion::translation(Pose::Identity(), {5, 0}), corner, kStill, options)->time, 1,
              1e-5);
  options.margin = 3 - 1e-9;
  EXPECT_FALSE(timeOfImpact(point, Motion::translation(Pose::Identity(), {20, 0}), corner, kStill, options));
}

TEST(TimeOfImpact, PointsSaidOftenBesideEachOthersCorners) {
  // The margin is more than boxes' axes see of the distance, and boxes are as small as can be, whatever is divided.
  const Polygon a({Ring(40, {0, 0})}), b({Ring(40, {0, 0})});
  ImpactOptions options;
  options.margin = 1.2;
  Motion bent = Motion::still(turnedAndMoved(0, 1, 1));
  bent.shift_2 = Vec2(0.05, 0.05);
  EXPECT_FALSE(timeOfImpact(a, kStill, b, bent, options).has_value());
  bent.shift_2 = Vec2(-0.3, -0.3);
  options.margin = std::hypot(0.925, 0.925);
  expectImpact(a, kStill, b, bent, 0.5, kRounding, options);
}

TEST(TimeOfImpact, MarginAtAnyScale) {
  for (const double scale : {1e-300, 1e-150, 1.0, 1e150, 1e300}) {
    const Polygon square({scaled(rectangle(0, 0, 1, 1), scale)}), wall({scaled(rectangle(3, -10, 4, 10), scale)});
    ImpactOptions options;
    options.margin = 0.5 * scale;
    expectImpact(square, Motion::translation(Pose::Identity(), Vec2(8 * scale, 0)), wall, kStill, 1.5 / 8, kRounding,
                 options);
  }
}

TEST(TimeOfImpact, IsZeroWhereAFewOfTheSmallestDoublesCollide) {
  constexpr double e = std::numeric_limits<double>::denorm_min();
  const Polygon triangle({{{0, 0}, {e, 0}, {-e, e}}});
  EXPECT_EQ(timeOfImpact(triangle, kStill, triangle, Motion::still(turnedAndMoved(0.3, 0, 0)))->time, 0);
  Random random(4);
  int hits = 0;
  constexpr int kCases = 5000;
  for (int i = 0; i < kCases; ++i) {
    const auto polygon = [&] {
      Ring ring;
      for (int k = random.integer(3, 5); k > 0; --k)
        ring.emplace_back(e * random.integer(-2, 2), e * random.integer(-2, 2));
      return Polygon({ring});
    };
    const auto start = [&] {
      return turnedAndMoved(random.coin() ? random.real(0, 6) : 0, e * random.integer(-4, 4),
                            e * random.integer(-4, 4));
    };
    const Polygon a = polygon(), b = polygon();
    const Motion motion_a = Motion::still(start()), motion_b = turning(start(), random.coin() ? 1 : 0, {e, -2 * e});
    const bool collides = collide(a, motion_a.start, b, motion_b.start);
    const auto impact = timeOfImpact(a, motion_a, b, motion_b);
    ASSERT_EQ(impact && impact->time == 0, collides) << "case " << i;
    hits += collides;
  }
  EXPECT_GT(hits, kCases / 10);
  EXPECT_LT(hits, kCases / 2);
}

TEST(TimeOfImpact, RefusesWhatIsNoMotion) {
  const Polygon square({rectangle(0, 0, 1, 1)});
  Motion wrong;
  wrong.angle = std::numeric_limits<double>::quiet_NaN();
  const auto message = [&](const Motion& motion_a, const Motion& motion_b, double time_error) {
    ImpactOptions options;
    options.time_error = time_error;
    return refusal([&] { timeOfImpact(square, motion_a, square, motion_b, options); });
  };
  EXPECT_NE(message(wrong, kStill, 0).find("tricover: motion_a.angle: "), std::string::npos);
  EXPECT_NE(message(kStill, wrong, 0).find("motion_b.angle"), std::string::npos);
  for (const double time_error :
       {-1e-6, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_NE(message(kStill, kStill, time_error).find("tricover: time_error: "), std::string::npos);
}

/// Boxes alone could tell that they are within the margin, but an impact names its edges.
TEST(TimeOfImpact, WithinTheMarginAtTheStartNamesEdges) {
  const Polygon a({regular(64, 10)}), b({regular(60, 5)});
  Pose start = Pose::Identity();
  start.translation() << 15.5, 0;
  ImpactOptions options;
  for (const double margin : {0.75, 3.0}) {
    options.margin = margin;
    const auto impact = timeOfImpact(a, Motion::still(Pose::Identity()), b, Motion::still(start), options);
    ASSERT_TRUE(impact);
    EXPECT_EQ(impact->time, 0);
    EXPECT_GE(impact->edge_a, 0);
    EXPECT_GE(impact->edge_b, 0);
  }
}

/// Sides of a convex polygon may be divided: the edges that are named are the given ones.
TEST(TimeOfImpact, NamesTheEdgesOfDividedSides) {
  const Polygon a({{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {1, 2}, {0.25, 2}, {0, 2}, {0, 1}}});
  const Polygon wedge({{{-1, 1}, {0, 0}, {0.5, 0.5}, {1, 1}, {0, 1}}});
  const auto edgeAt = [&](double x) {
    Motion motion = Motion::still(turnedAndMoved(0, x, 2.5));
    motion.shift = Vec2(0, -1);
    const Impact impact = expectImpact(a, Motion::still(Pose::Identity()), wedge, motion, 0.5);
    EXPECT_TRUE(impact.edge_b == 0 || impact.edge_b == 1);
    return impact.edge_a;
  };
  EXPECT_EQ(edgeAt(1.5), 4);
  EXPECT_EQ(edgeAt(0.5), 6);
  EXPECT_EQ(edgeAt(0.125), 7);
}

/// From so far that squares of lengths, in lengths of the way, are no doubles any more.
TEST(TimeOfImpact, OfAPointThatComesFromVeryFar) {
  for (const Polygon& a : {Polygon({regular(8, 1)}), Polygon({comb(3, 1, 0.5, 2)})}) {
    for (int exponent = 60; exponent <= 1000; exponent += 20) {
      const double far = std::ldexp(1.0, exponent);
      Motion motion = Motion::still(turnedAndMoved(0, -far, 0.25));
      motion.shift = Vec2(2 * far, 0);
      SCOPED_TRACE(exponent);
      expectImpact(a, Motion::still(Pose::Identity()), point({0, 0}), motion, 0.5);
    }
  }
}

}  // namespace
}  // namespace tricover::support
