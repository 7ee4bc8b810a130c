// SPDX-License-Identifier: BSD-3-Clause
// Impacts whose times are known by hand.
#include "tricover/time_of_impact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "refusal.h"
#include "shapes.h"
#include "tricover/polygon.h"

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

constexpr double kNever = 2;

struct Row {
  Polygon a;
  Motion motion_a;
  Polygon b;
  Motion motion_b;
  double truth;
  double rounding = kRounding;
};

void expectImpacts(const std::vector<Row>& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    SCOPED_TRACE("row " + std::to_string(i));
    const Row& row = rows[i];
    if (row.truth == kNever)
      expectFree(row.a, row.motion_a, row.b, row.motion_b);
    else
      expectImpact(row.a, row.motion_a, row.b, row.motion_b, row.truth, row.rounding);
  }
}

Motion still(double x, double y) { return Motion::still(turnedAndMoved(0, x, y)); }
Motion going(double x, double y, const Vec2& way) { return Motion::translation(turnedAndMoved(0, x, y), way); }

const Polygon kSquare({rectangle(0, 0, 1, 1)}), kWall({rectangle(3, -10, 4, 10)});

/// Whichever is far away, nothing overflows on the way to the pair's own length.
TEST(TimeOfImpact, OfAPairAtRestIsNone) {
  const Polygon large({rectangle(-2, -2, 2, 2)}), small({rectangle(-1, -1, 1, 1)});
  for (const Vec2& far : {Vec2(1e12, 0), Vec2(0, -1e200), Vec2(1e300, 1e300)})
    expectImpacts({{large, kStill, small, still(far.x(), far.y()), kNever},
                   {large, still(far.x(), far.y()), small, kStill, kNever}});
  const Polygon c({{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {4, 3}, {4, 4}, {0, 4}}});
  expectImpacts({{c, kStill, kSquare, still(2, 1.5), kNever}});
}

TEST(TimeOfImpact, SquareMeetsWall) {
  const Impact impact = expectImpact(kSquare, going(0, 0, {8, 0}), kWall, kStill, 0.25);
  EXPECT_NEAR((impact.normal - Vec2(1, 0)).norm(), 0, 1e-7);
  EXPECT_NEAR(impact.point.x(), 3, 1e-5);
  EXPECT_GE(impact.point.y(), 0);
  EXPECT_LE(impact.point.y(), 1);
  EXPECT_EQ(impact.edge_b, 3);
}

TEST(TimeOfImpact, CornerMeetsWall) {
  const Polygon square({rectangle(-1, -1, 1, 1)});
  const Impact impact = expectImpact(square, Motion::translation(turnedAndMoved(kPi / 4, 0, 0.5), {2, 0}), kWall,
                                     kStill, (3 - std::sqrt(2)) / 2);
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

TEST(TimeOfImpact, GrazeIsContactAndAHairAsideIsFree) {
  // A vertex that brushes a vertex, and one that turns and brushes a wall at the top of its circle.
  const Polygon tip({{{0, 1}, {-1, 0}, {1, 0}}}), down({{{0, 1}, {1, 2}, {-1, 2}}}), wall({rectangle(-9, 1, 9, 2)});
  const Polygon rod({rectangle(0, -0.1, 2, 0.1)}), post({rectangle(-0.05, -0.05, 0.05, 0.05)});
  expectImpacts({
      {kSquare, going(0, 0, {10, 0}), kSquare, still(5, 1), 0.4},
      {kSquare, going(0, -1e-9, {10, 0}), kSquare, still(5, 1), kNever},
      {tip, going(-4, 0, {8, 0}), down, kStill, 0.5},
      {tip, going(-4, -1e-9, {8, 0}), down, kStill, kNever},
      {tip, turning(turnedAndMoved(-1, 0, 0), 2), wall, kStill, 0.5, 1e-6},
      {tip, turning(turnedAndMoved(-1, 0, 0), 2), wall, still(0, 1e-9), kNever},
      // Contact at the end counts.
      {kSquare, going(0, 0, {4, 0}), kSquare, still(5, 0.5), 1},
      {kSquare, going(0, 0, {4 - 1e-9, 0}), kSquare, still(5, 0.5), kNever},
      // Past the rod's end; and from 0.3 to 20 degrees before that, the post in the middle of the rest.
      {rod, turning(Pose::Identity(), 350 * kPi / 180), post, still(2.06, 0), kNever},
      {rod, turning(turnedAndMoved(0.3, 0, 0), 340 * kPi / 180), post,
       Motion::still(turnedAndMoved(0.1255, 1.5 * std::cos(0.1255), 1.5 * std::sin(0.1255))), kNever},
  });
}

TEST(TimeOfImpact, OverlapAtTheStartIsTimeZero) {
  const Polygon large({rectangle(-5, -5, 6, 6)});
  // Parting from a touch.
  const Impact touch = expectImpact(kSquare, kStill, kSquare, going(1, 0, {1, 0}), 0);
  EXPECT_EQ(touch.time, 0);
  EXPECT_EQ(touch.normal, Vec2(1, 0));
  EXPECT_EQ(touch.point.x(), 1);
  // Held inside, no edges meeting.
  const Impact held = expectImpact(kSquare, turning(Pose::Identity(), 3), large, kStill, 0);
  EXPECT_EQ(held.time, 0);
  EXPECT_EQ(held.point, Vec2(0, 0));
  EXPECT_EQ(held.edge_a, 0);
  EXPECT_EQ(held.edge_b, -1);
  EXPECT_EQ(expectImpact(kSquare, kStill, kSquare, Motion::still(turnedAndMoved(0.2, 0.5, 0)), 0).time, 0);
}

/// collide() at the start <=> time 0, though rounding can't tell these from a touch.
TEST(TimeOfImpact, AnUlpApartIsNotTimeZero) {
  for (const double x : {nudged(1, 1), nudged(-1, -1)}) {
    const auto impact = timeOfImpact(kSquare, kStill, kSquare, going(x, 0, {-x, 0}));
    ASSERT_TRUE(impact);
    EXPECT_GT(impact->time, 0);
    EXPECT_LT(impact->time, 1e-15);
    EXPECT_EQ(impact->normal, Vec2(x > 0 ? 1 : -1, 0));
  }
}

TEST(TimeOfImpact, InRoomsAndHoles) {
  // A box with a gap of 1 in its right wall.
  const Polygon room(
      {{{0, 0}, {10, 0}, {10, 4.5}, {9, 4.5}, {9, 1}, {1, 1}, {1, 9}, {9, 9}, {9, 5.5}, {10, 5.5}, {10, 10}, {0, 10}}});
  const Polygon ball({regular(16, 0.45)}), disc({regular(16, 1)});
  const Polygon frame({rectangle(-10, -10, 10, 10), rectangle(-5, -5, 5, 5)});
  const Polygon annulus({regular(64, 12), regular(64, 10), regular(64, 5)}), round({regular(12, 2)});
  const auto orbit = [](const Vec2& shift) { return turning(turnedAndMoved(0, 7.5, 0), 6 * kPi, shift, {-7.5, 0}); };
  expectImpacts({
      {room, kStill, ball, going(5, 5, {20, 0}), kNever},
      {room, kStill, ball, turning(turnedAndMoved(0, 5, 5), 50, {20, 0}), kNever},
      {room, kStill, ball, going(5, 3, {16, 0}), (9 - 0.45 - 5) / 16},
      {frame, kStill, disc, going(0, 0, {0, 40}), 0.1},
      {frame, kStill, disc, going(0, 0, {0, 3.9}), kNever},
      // Three turns about the common centre, 7.5 away; the annulus turns the other way.
      {annulus, kStill, round, orbit({0, 0}), kNever},
      {annulus, turning(Pose::Identity(), -20), round, orbit({0, 0}), kNever},
  });
  EXPECT_TRUE(timeOfImpact(annulus, kStill, round, orbit({2, 0}))) << "spirals out";
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
TEST(TimeOfImpact, MovingTogetherIsFree) {
  for (const double gap : {1e-2, 1e-4, 1e-6, 1e-9, 1e-12})
    expectFree(kSquare, turning(Pose::Identity(), kPi), kSquare,
               turning(turnedAndMoved(0, 1 + gap, 0), kPi, Vec2::Zero(), {-1 - gap, 0}));
  const Motion spline = Motion::spline({{0, 0}, 0, {50, 0}, 9}, {{10, 10}, 20, {0, 70}, -5});
  expectFree(Polygon({rectangle(-2, -1, -1, 1)}), spline, Polygon({rectangle(1, -1, 2, 1)}), spline);
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
  // The corner (4, 1) comes from above to the wall's top (3, -10) .. only where the wall is: meets x = 3 at acos(3/r).
  const double met = std::acos(3 / std::hypot(4.0, 1.0)) + std::atan2(1.0, 4.0);
  for (const double scale : {1e-300, 1e-150, 1e-9, 1.0, 1e9, 1e150, 1e300}) {
    const Polygon square = kSquare.scaled(scale), wall = kWall.scaled(scale);
    expectImpacts({{square, going(0, 0, Vec2(8, 0) * scale), wall, kStill, 0.25},
                   {square, going(0, 0, Vec2(0, 8) * scale), wall, kStill, kNever},
                   {Polygon({scaled(rectangle(0, -1, 4, 1), scale)}), turning(turnedAndMoved(kPi / 2, 0, 0), -2), wall,
                    kStill, (kPi / 2 - met + 2 * std::atan2(1.0, 4.0)) / 2, 1}});
    ImpactOptions options;
    options.margin = 0.5 * scale;
    expectImpact(square, going(0, 0, Vec2(8, 0) * scale), wall, kStill, 1.5 / 8, kRounding, options);
  }
  const Polygon bullet({scaled(rectangle(-1, -1, 1, 1), 1e-200)}), wall({scaled(rectangle(0, -1, 1, 1), 1e100)});
  expectImpacts({{bullet, going(-1e100, 0, {1e101, 0}), wall, kStill, 0.1},
                 {bullet, going(-1e100, 0, {0, 1e101}), wall, kStill, kNever}});
  // Near the largest double nothing is proven to be apart, but what is far away.
  const Polygon huge({scaled(rectangle(-1, -1, 1, 1), 1e308)});
  EXPECT_TRUE(timeOfImpact(huge, turning(turnedAndMoved(0.3, -1e308, 1e308), 3, {1e308, 1e308}), huge, kStill));
}

TEST(TimeOfImpact, FarFromTheOrigin) {
  const Pose here = turnedAndMoved(0, 1e15, -1e15);
  const Motion there = still(1e15 + 3, -1e15);
  expectImpact(kSquare, Motion::translation(here, {4, 0}), kSquare, there, 0.5);
  EXPECT_EQ(expectImpact(kSquare, turning(here, 0, {4, 0}), kSquare, there, 0.5).point.x(), 1e15 + 3);
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
  const auto cubic = [](double x, double x_2, double x_3) {
    Motion motion;
    motion.shift.x() = x, motion.shift_2.x() = x_2, motion.shift_3.x() = x_3;
    return motion;
  };
  // A rod that is upright after a quarter turn, at 4 t^3 = 1.
  const Polygon rod({rectangle(-4, -0.001, 4, 0.001)}), post({rectangle(-0.001, 3, 0.001, 3.5)});
  Motion speeds_up;
  speeds_up.angle_3 = 2 * kPi;
  expectImpacts({
      {kSquare, cubic(0, 0, 16), kWall, kStill, 0.5},                               // 16 t^3 = 2
      {kSquare, cubic(0, 8, 0), kWall, kStill, 0.5},                                // 8 t^2 = 2
      {kSquare, cubic(-4, 12, 0), kWall, kStill, (4 + std::sqrt(16.0 + 96)) / 24},  // back first: 12 t^2 - 4 t = 2
      // There and back again: 8 t - 8 t^2 is 2 at most, at t = 1/2.
      {kSquare, cubic(8, -8, 0), kWall, kStill, 0.5, 1e-5},
      {kSquare, cubic(std::nextafter(8, 0) - 1e-9, -8, 0), kWall, kStill, kNever},
      {rod, speeds_up, post, kStill, std::cbrt(0.25), 2 * 0.002 / 3.5 / (2 * kPi)},
  });
}

TEST(TimeOfImpact, MarginIsMetSoonerByAsMuch) {
  const Motion motion = going(0, 0, {8, 0});
  ImpactOptions options;
  options.margin = 0.5;
  const Impact impact = expectImpact(kSquare, motion, kWall, kStill, 1.5 / 8, kRounding, options);
  EXPECT_NEAR((impact.normal - Vec2(1, 0)).norm(), 0, 1e-7);
  EXPECT_NEAR(impact.point.x(), 2.75, 1e-5);
  options.margin = 2;  // as near as that from the beginning
  EXPECT_EQ(expectImpact(kSquare, motion, kWall, kStill, 0, kRounding, options).time, 0);
  options.margin = std::nextafter(2, 0);
  EXPECT_GT(timeOfImpact(kSquare, motion, kWall, kStill, options)->time, 0);
  // Past a corner: a graze of the margin's disc around it.
  const Polygon dot = Polygon::point({0, 0}), corner({rectangle(5, 3, 6, 4)});
  options.margin = 3;
  EXPECT_NEAR(timeOfImpact(dot, going(0, 0, {5, 0}), corner, kStill, options)->time, 1, 1e-5);
  options.margin = 3 - 1e-9;
  EXPECT_FALSE(timeOfImpact(dot, going(0, 0, {20, 0}), corner, kStill, options));
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

TEST(TimeOfImpact, IsZeroWhereAFewOfTheSmallestDoublesCollide) {
  constexpr double e = std::numeric_limits<double>::denorm_min();
  const Polygon triangle({{{0, 0}, {e, 0}, {-e, e}}});
  EXPECT_EQ(timeOfImpact(triangle, kStill, triangle, Motion::still(turnedAndMoved(0.3, 0, 0)))->time, 0);
}

TEST(TimeOfImpact, RefusesWhatIsNoMotion) {
  Motion wrong;
  wrong.angle = std::numeric_limits<double>::quiet_NaN();
  const auto message = [&](const Motion& motion_a, const Motion& motion_b, double time_error) {
    ImpactOptions options;
    options.time_error = time_error;
    return refusal([&] { timeOfImpact(kSquare, motion_a, kSquare, motion_b, options); });
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
  ImpactOptions options;
  for (const double margin : {0.75, 3.0}) {
    options.margin = margin;
    const auto impact = timeOfImpact(a, kStill, b, still(15.5, 0), options);
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
    const Impact impact = expectImpact(a, kStill, wedge, going(x, 2.5, {0, -1}), 0.5);
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
      SCOPED_TRACE(exponent);
      expectImpact(a, kStill, Polygon::point({0, 0}), going(-far, 0.25, {2 * far, 0}), 0.5);
    }
  }
}

}  // namespace
}  // namespace tricover::support
