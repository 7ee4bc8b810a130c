// SPDX-License-Identifier: BSD-3-Clause
// A negative margin allows an overlap: regions collide where a point of either is as deep in the other as that.
// negative_margin_faults_test.cpp has what was once wrong.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "families.h"
#include "random.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/conflicts.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/least_distance.h"
#include "tricover/penetration.h"
#include "tricover/polygon.h"
#include "tricover/ray.h"
#include "tricover/scene.h"
#include "tricover/time_of_impact.h"

namespace tricover::support {
namespace {

constexpr double kErrors[] = {1e-2, 1e-6, 1e-9, 1e-12};
constexpr double kAllowed[] = {1e-9, 1e-6, 1e-3, 0.05};

const Polygon kFloor = Polygon::box(20, 1), kCrate = Polygon::box(1, 1);
/// A floor at height 0.5 with a wall at x = 1.5.
const Polygon kRoom(Ring{{-10, -1}, {10, -1}, {10, 5}, {1.5, 5}, {1.5, 0.5}, {-10, 0.5}});

Pose at(double x, double y) { return tricover::poseAt(x, y); }
Motion still(double x, double y) { return Motion::still(at(x, y)); }
Motion slide(double x, double y, const Vec2& shift) { return Motion::translation(at(x, y), shift); }

ImpactOptions allowing(double overlap, double time_error = 1e-6, bool ignore_initial = false) {
  ImpactOptions options;
  options.margin = -overlap;
  options.time_error = time_error;
  options.ignore_initial = ignore_initial;
  return options;
}

void expectImpact(const std::optional<Impact>& impact, double time, double error) {
  ASSERT_TRUE(impact);
  EXPECT_FALSE(impact->budget_ended);
  EXPECT_LE(impact->time, time + 1e-11);
  EXPECT_GE(impact->time, time - error - 1e-11);
  EXPECT_NEAR(impact->normal.norm(), 1, 1e-12);
}

TEST(NegativeMargin, ComparesDepths) {
  const Pose here = at(0, 0), quarter = at(0.75, 0.125);  // in each other by a quarter, which is exact
  const auto deeper = [&](double overlap, const Pose& pose_b, Touching touching = Touching::Collides) {
    return collide(kCrate, here, kCrate, pose_b, {-overlap, 0, touching});
  };
  EXPECT_FALSE(deeper(0.375, quarter));
  EXPECT_TRUE(deeper(0.25, quarter));
  EXPECT_FALSE(deeper(0.25, quarter, Touching::Allowed));
  EXPECT_TRUE(deeper(0.25 - 0x1p-40, quarter, Touching::Allowed));
  for (const double overlap : {5e-324, 1e-300, 1e-12, 1e300}) {
    EXPECT_FALSE(deeper(overlap, at(1, 0.25))) << overlap;  // they touch
    EXPECT_EQ(deeper(overlap, here), overlap <= 0.5);
  }
  // In a corner, on the floor and at the wall: into both by as much is 1.41 times as deep.
  for (const double floor : {0.0, 1e-9, 5e-7})
    for (const double wall : {0.0, 1e-9, 5e-7})
      EXPECT_FALSE(collide(kRoom, here, kCrate, at(1 + wall, 1 - floor), {-1e-6}));  // by up to 7.1e-7
  EXPECT_TRUE(collide(kRoom, here, kCrate, at(1 + 8e-7, 1 - 8e-7), {-1e-6}));
}

TEST(NegativeMargin, RefusesWhatMeansNothing) {
  const Pose here = at(0, 0);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double bad : {-kInfinity, kInfinity, std::nan("")}) {
    EXPECT_THROW(collide(kCrate, here, kCrate, here, {bad, 0}), std::invalid_argument);
    EXPECT_THROW(timeOfImpact(kCrate, still(0, 0), kCrate, still(0, 0), allowing(bad)), std::invalid_argument);
    EXPECT_THROW(conflicts(kCrate, still(0, 0), kCrate, still(0, 0), allowing(bad)), std::invalid_argument);
    Scene scene;
    EXPECT_THROW(scene.colliding(kCrate, here, {bad, 0}), std::invalid_argument);
  }
  EXPECT_THROW(collide(kCrate, here, kCrate, here, {-1, -1}), std::invalid_argument);
  EXPECT_THROW(distance(kCrate, here, kCrate, here, {-1}), std::invalid_argument);
  EXPECT_THROW(penetration(kCrate, here, kCrate, here, {-1}), std::invalid_argument);
  EXPECT_THROW(contacts(kCrate, here, kCrate, here, {-1}), std::invalid_argument);
  EXPECT_THROW(crossings(kCrate, here, kCrate, here, {-1}), std::invalid_argument);
  EXPECT_THROW(castRay(kCrate, here, {0, 0}, {1, 1}, {-1}), std::invalid_argument);
  EXPECT_THROW(leastDistance(kCrate, still(0, 0), kCrate, still(0, 0), {-1}), std::invalid_argument);
}

TEST(NegativeMargin, ACrateSlidesOnAFloorLeavesAndDocks) {
  for (const double error : kErrors)
    for (const double overlap : kAllowed) {
      SCOPED_TRACE(::testing::Message() << "time error " << error << ", allowed " << overlap);
      const ImpactOptions options = allowing(overlap, error);
      const auto impact = [&](const Motion& motion) {
        return timeOfImpact(kFloor, still(0, 0), kCrate, motion, options);
      };
      for (const double above : {0.0, -overlap / 2, overlap / 2}) {
        for (const Vec2& way : {Vec2(4, 0), Vec2(40, 0), Vec2(1, 3)}) EXPECT_FALSE(impact(slide(-2, 1 + above, way)));
        EXPECT_TRUE(conflicts(kFloor, still(0, 0), kCrate, slide(-2, 1 + above, {4, 0}), options).empty());
      }
      EXPECT_FALSE(impact(slide(-15, 4, {13, -3})));  // docks
      EXPECT_FALSE(impact(Motion::spline({{-5, 1}, 0, {6, 0}, 0}, {{5, 1}, 0, {8, 0}, 0})));
      // They rotate alike.
      Motion a = still(0, 0), b = still(-2, 1);
      a.angle = b.angle = 1;
      b.pivot = Vec2(2, -1);
      EXPECT_FALSE(timeOfImpact(kFloor, a, kCrate, b, options));
      expectImpact(impact(slide(-2, 1, {0, -1})), overlap, error);  // down into the floor
      // It tips over its corner, onto the next side, and on into the floor.
      Motion tips = still(-2, 1);
      tips.pivot = Vec2(0.5, -0.5);
      tips.angle = -2;
      const auto tipped = impact(tips);
      ASSERT_TRUE(tipped);
      EXPECT_NEAR(tipped->time, M_PI / 4, overlap + error);
      EXPECT_GE(tipped->time, M_PI / 4 - 1e-9);
    }
}

/// A body that isn't convex, too: its sides can't all be shrunk, and only translations keep it away from the floor.
TEST(NegativeMargin, ACrateSlidesIntoAWallOfTheFloorsOwnPolygon) {
  const Polygon stair(Ring{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0}, {0, 0}, {0, 0.5}, {-0.5, 0.5}});
  for (const double error : kErrors)
    for (const double overlap : kAllowed) {
      SCOPED_TRACE(::testing::Message() << "time error " << error << ", allowed " << overlap);
      const ImpactOptions options = allowing(overlap, error);
      const Motion slides = slide(-2, 1, {4, 0});
      for (const Polygon* body : {&kCrate, &stair}) {
        const auto impact = timeOfImpact(kRoom, still(0, 0), *body, slides, options);
        expectImpact(impact, 0.75 + overlap / 4, error);
        EXPECT_NEAR(impact->normal.x(), -1, 1e-6);
        EXPECT_FALSE(timeOfImpact(kFloor, still(0, 0), *body, slides, options));
      }
      // Up to the wall, and back.
      Motion returns = slide(-2, 1, {12, 0});
      returns.shift_2 = Vec2(-12, 0);
      EXPECT_FALSE(timeOfImpact(kRoom, still(0, 0), kCrate, returns, options));
    }
}

TEST(NegativeMargin, ACorridorOfTheCratesOwnWidth) {
  const Polygon walls({rectangle(-20, 0.5, 20, 2), rectangle(-20, -2, 20, -0.5)});
  const Polygon slot(Ring{{-3, -3}, {3, -3}, {3, 3}, {0.5, 3}, {0.5, -2}, {-0.5, -2}, {-0.5, 3}, {-3, 3}});
  for (const double overlap : kAllowed) {
    SCOPED_TRACE(overlap);
    EXPECT_FALSE(timeOfImpact(walls, still(0, 0), kCrate, slide(-30, 0, {60, 0}), allowing(overlap)));
    EXPECT_TRUE(conflicts(walls, still(0, 0), kCrate, slide(-30, 0, {60, 0}), allowing(overlap)).empty());
    // Into the slot, down to its end at 5.5 / 8.
    expectImpact(timeOfImpact(slot, still(0, 0), kCrate, slide(0, 4, {0, -8}), allowing(overlap)), (5.5 + overlap) / 8,
                 1e-6);
  }
}

TEST(NegativeMargin, WhatStartsDeeper) {
  const Polygon square = Polygon::box(2, 2);
  for (const double error : kErrors) {
    SCOPED_TRACE(error);
    const Motion passes = slide(0.5, 0, {10, 0});
    Motion returns = slide(0.5, 0, {20, 0});
    returns.shift_2 = Vec2(-20, 0);
    EXPECT_EQ(timeOfImpact(square, still(0, 0), square, passes, allowing(0.25, error))->time, 0);
    EXPECT_FALSE(timeOfImpact(square, still(0, 0), square, passes, allowing(0.25, error, true)));
    EXPECT_TRUE(conflicts(square, still(0, 0), square, passes, allowing(0.25, error, true)).empty());
    // 0.5 + 20 t (1 - t) is 1.75 again at 0.5 (1 + sqrt(0.75)).
    const double back = 0.5 * (1 + std::sqrt(0.75));
    expectImpact(timeOfImpact(square, still(0, 0), square, returns, allowing(0.25, error, true)), back, error + 1e-9);
  }
}

/// A robot in a yard of which all the outside is forbidden, along one wall to the next.
TEST(NegativeMargin, InsideOfAComplement) {
  const Polygon outside = Polygon::box(20, 10).complement();
  EXPECT_FALSE(timeOfImpact(outside, still(0, 0), kCrate, slide(-5, 4.5, {10, 0}), allowing(1e-6)));
  expectImpact(timeOfImpact(outside, still(0, 0), kCrate, slide(-5, 4.5, {20, 0}), allowing(1e-6)), (14.5 + 1e-6) / 20,
               1e-6);
}

TEST(NegativeMargin, InScenes) {
  Scene scene;
  BodyOptions rests;
  rests.margin = -1e-6;
  const Scene::Body room = scene.add(kRoom, at(0, 0)), crate = scene.add(kCrate, at(-2, 1 - 1e-9), rests),
                    other = scene.add(kCrate, at(-4, 1 - 1e-9), rests);
  EXPECT_TRUE(scene.collisions().empty());
  for (int i = 0; i < 100; ++i) {
    scene.move(crate, at(-2 + 0.04 * i, 1 - 1e-9));
    EXPECT_EQ(scene.collisions().empty(), i <= 75) << i;
  }
  scene.move(crate, at(-2, 1));
  scene.move(other, at(-4, 1));
  EXPECT_TRUE(scene.collisions().empty());
  scene.setOptions(crate, {});
  EXPECT_EQ(scene.collisions().size(), 1u);
  scene.setOptions(crate, rests);
  EXPECT_TRUE(scene.collisions().empty());
  // Margins of a body and of a query add up.
  EXPECT_TRUE(scene.collides(kCrate, at(3, 0.5)));
  EXPECT_FALSE(scene.collides(kCrate, at(-7, 1), {-1e-6, 0}));
  EXPECT_TRUE(scene.collides(kCrate, at(-7, 1)));
  EXPECT_EQ(scene.colliding(kCrate, at(-3, 2)).size(), 0u);
  EXPECT_EQ(scene.colliding(kCrate, at(-3, 2), {1e-6, 0}).size(), 2u);
  EXPECT_EQ(scene.colliding(kCrate, at(-2.5, 1.5), {-0.25, 0}), std::vector<Scene::Body>{crate});
  // Where nothing is deep enough, a large body learns no box that is clear.
  Scene large;
  large.add(kRoom, at(0, 0));
  const Polygon speck = Polygon::box(0.1, 0.1);
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(large.collides(speck, at(5, 2), {-5, 0}));
  EXPECT_TRUE(large.collides(speck, at(5, 2)));
  const auto impact = scene.firstImpact(kCrate, slide(-8, 1, {16, 0}), allowing(1e-6));
  ASSERT_TRUE(impact);
  EXPECT_EQ(impact->body, other);
  const auto pairs = scene.impacts({{crate, slide(-2, 1, {4, 0})}});
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].pair, (BodyPair{room, crate}));
  EXPECT_NEAR(pairs[0].impact.time, 0.75, 1e-6);
  EXPECT_EQ(scene.conflicts({{crate, Trajectory({{0, 1, slide(-2, 1, {4, 0})}})}}).size(), 1u);
  // Distances and rays take a negative sum for none.
  EXPECT_EQ(scene.nearest(kCrate, at(-2, 3), {}, BodyFilter::allBut(room))->result.distance, 1);
  EXPECT_EQ(scene.castRay({-2, 3}, {-2, 0})->body, crate);
}

/// A scene's collisions are those that collide() finds after every move, however short: no certificate outlasts an
/// overlap that is allowed.
TEST(NegativeMargin, CollisionsOfASceneKeepUpWithMoves) {
  Random random(2);
  int met = 0, deep = 0, changes = 0;
  for (int run = 0; run < scaledCount(40); ++run) {
    Scene scene;
    std::vector<std::pair<Scene::Body, Vec2>> bodies;  // and how they drift
    for (int i = 0; i < 6; ++i) {
      BodyOptions options;
      options.margin = random.oneIn(3) ? 0 : -random.real(0, 0.2);
      bodies.emplace_back(scene.add(Polygon(star(random, 7, 0.4, 1)), randomPose(random, 1), options),
                          Vec2(random.real(-0.02, 0.02), random.real(-0.02, 0.02)));
    }
    std::vector<BodyPair> before;
    for (int step = 0; step < 40; ++step) {
      for (const auto& [body, drift] : bodies) {
        Pose pose = scene.pose(body);
        pose.translation() += drift;
        if (body % 2 == 0 || step % 3 == 0) scene.move(body, pose);
      }
      std::vector<BodyPair> expected;
      for (const auto& [p, drift_p] : bodies)
        for (const auto& [q, drift_q] : bodies) {
          if (p >= q) continue;
          const double margin = scene.options(p).margin + scene.options(q).margin;
          const Case c{scene.polygon(p), scene.pose(p), scene.polygon(q), scene.pose(q)};
          met += collide(c.a, c.pose_a, c.b, c.pose_b);
          if (collide(c.a, c.pose_a, c.b, c.pose_b, {margin})) expected.push_back({p, q});
        }
      std::sort(expected.begin(), expected.end());
      ASSERT_EQ(scene.collisions(), expected) << "run " << run << ", step " << step;
      deep += static_cast<int>(expected.size());
      changes += expected != before;
      before = expected;
    }
  }
  EXPECT_GT(deep, met / 4);
  EXPECT_LT(deep, met * 9 / 10);
  EXPECT_GT(changes, scaledCount(40));
}

TEST(NegativeMargin, PosesOffRigidTheTinyAndTheHuge) {
  for (const double size : {1e-200, 1e-6, 1e6, 1e200}) {
    SCOPED_TRACE(size);
    const Polygon room = kRoom.scaled(size), crate = kCrate.scaled(size);
    const auto impact =
        timeOfImpact(room, still(0, 0), crate, slide(-2 * size, size, {4 * size, 0}), allowing(1e-6 * size));
    expectImpact(impact, 0.75 + 0.25e-6, 1e-6);
  }
  // Along a cubic, whose speed has squares that underflow, down into the floor.
  for (const double size : {1e-245, 1.0, 1e200}) {
    Motion falls = still(-2 * size, 2 * size);
    falls.shift_3 = Vec2(0, -8 * size);
    const auto impact =
        timeOfImpact(kFloor.scaled(size), still(0, 0), kCrate.scaled(size), falls, allowing(1e-3 * size));
    expectImpact(impact, std::cbrt(1.001 / 8), 1e-6);
  }
  for (const double off : {4e-15, 1e-10, 4e-5}) {
    Motion motion = slide(-2, 1 + 0.5 * off, {4, 0});
    motion.start.linear() *= 1 + off;
    const auto impact = timeOfImpact(kRoom, still(0, 0), kCrate, motion, allowing(1e-6));
    ASSERT_TRUE(impact && !impact->budget_ended);
    EXPECT_NEAR(impact->time, 0.75, 2 * off + 2e-6) << off;
  }
}

TEST(NegativeMargin, SlidesExactlyAsDeepAsIsAllowed) {
  for (const double error : kErrors)
    for (const double overlap : {1e-6, 0.05, 0.25})
      for (const double off : {0.0, 1e-17, -1e-17, 1e-13, -1e-13}) {
        SCOPED_TRACE(::testing::Message() << "time error " << error << ", allowed " << overlap << ", off " << off);
        const Motion slides = slide(-2, 1 - overlap + off, {4, 0});
        const auto found = conflicts(kFloor, still(0, 0), kCrate, slides, allowing(overlap, error));
        ASSERT_EQ(found.size(), 1u);
        EXPECT_LE(found[0].impact.time, 1e-11);
        EXPECT_EQ(found[0].end, 1);
        EXPECT_FALSE(found[0].budget_ended);
        for (const Polygon* floor : {&kFloor, &kRoom})
          expectImpact(timeOfImpact(*floor, still(0, 0), kCrate, slides, allowing(overlap, error)), 0, error);
      }
}

}  // namespace
}  // namespace tricover::support
