// SPDX-License-Identifier: BSD-3-Clause
// Negative margins where overlaps were once measured by translations that lead out: corners, docks, segments, edges
// used twice, bodies that aren't convex; and what the measure says of walls, complements and scenes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "random.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/conflicts.h"
#include "tricover/depth.h"
#include "tricover/polygon.h"
#include "tricover/scene.h"
#include "tricover/signed_distance.h"
#include "tricover/time_of_impact.h"

namespace tricover::support {
namespace {

const Pose kHere = Pose::Identity();

Pose at(double x, double y, double heading = 0) { return tricover::poseAt(x, y, heading); }
Motion still(double x, double y) { return Motion::still(at(x, y)); }
Motion slide(double x, double y, const Vec2& by) { return Motion::translation(at(x, y), by); }

bool collides(const Polygon& a, const Polygon& b, const Pose& pose_b, double margin,
              Touching touching = Touching::Collides) {
  const CollideOptions options{margin, 0, touching};
  const bool answer = collide(a, kHere, b, pose_b, options);
  EXPECT_EQ(collide(b, pose_b, a, kHere, options), answer);
  return answer;
}

ImpactOptions allowing(double overlap, double error = 1e-6) {
  ImpactOptions options;
  options.margin = -overlap;
  options.time_error = error;
  return options;
}

/// Conflicts and times of impact against collide() at many times: deep poses are in an interval, and no time of impact
/// is after the first of them.
void expectDeepTimesWithin(const Polygon& a, const Motion& way_a, const Polygon& b, const Motion& way_b,
                           double overlap) {
  const double error = 1e-4;
  const auto found = conflicts(a, way_a, b, way_b, allowing(overlap, error));
  const auto impact = timeOfImpact(a, way_a, b, way_b, allowing(overlap, error));
  const auto isDeep = [&](double time) { return collide(a, way_a.at(time), b, way_b.at(time), {-overlap}); };
  EXPECT_EQ(impact.has_value(), !found.empty());
  for (const Conflict& c : found) EXPECT_TRUE(c.end == 1 || !isDeep(c.end)) << c.end;
  for (int i = 0; i <= 1000; ++i) {
    const double time = i / 1000.0;
    const auto holds = [&](const Conflict& c) { return c.impact.time <= time && time <= c.end; };
    if (!isDeep(time)) continue;
    ASSERT_TRUE(impact);
    ASSERT_LE(impact->time, time);
    ASSERT_TRUE(std::any_of(found.begin(), found.end(), holds)) << time;
  }
}

TEST(NegativeMarginFaults, InACorner) {
  const Polygon room = Polygon::box(10, 10).complement(), crate = Polygon::box(2, 2);
  EXPECT_FALSE(collides(room, crate, at(-4 - 1e-12, -4 - 1e-12), -1));
  EXPECT_TRUE(collides(room, crate, at(-4.01, -4.01), -0.0141));
  EXPECT_FALSE(collides(room, crate, at(-4.01, -4.01), -0.0142));
  // Its end is as far outside as 1.41 mm, which 1 cm allows; 1 mm doesn't, with a wait at the end or without.
  const Motion into = Motion::translation(at(0, 0), {-4.001, -4.001});
  EXPECT_TRUE(conflicts(room, still(0, 0), crate, into, allowing(0.01)).empty());
  const auto found = conflicts(room, still(0, 0), crate, into, allowing(0.001));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].impact.time, (4 + 0.001 / std::sqrt(2)) / 4.001, 1e-5);
  EXPECT_EQ(found[0].end, 1);
  const Trajectory waits({{0, 1, into}, {1, 2, still(-4.001, -4.001)}}), rests({{0, 2, still(0, 0)}});
  EXPECT_TRUE(conflicts(room, rests, crate, waits, allowing(0.01)).empty());
  const auto waited = conflicts(room, rests, crate, waits, allowing(0.001));
  ASSERT_EQ(waited.size(), 1u);
  EXPECT_EQ(waited[0].end, 2);
}

/// A room of more vertices than a search for a translation takes: the same answers.
TEST(NegativeMarginFaults, InACornerOfALargeMap) {
  Ring map{{0, 0}, {9, 0}, {9, 1}, {1, 1}};
  for (int i = 1; i < 5000; ++i) map.emplace_back(1, 1 + 8.0 * i / 5000);
  map.insert(map.end(), {{1, 9}, {0, 9}});
  const Polygon corner(map), crate = Polygon::box(2, 2);
  Random random(1);
  int deep = 0;
  for (int i = 0; i < 100; ++i) {
    const double x = random.real(0, 1.3e-3), y = random.real(0, 1.3e-3);
    const double depth = std::hypot(x, y);
    if (std::abs(depth - 1e-3) < 1e-9) continue;
    EXPECT_EQ(collides(corner, crate, at(2 - x, 2 - y), -1e-3), depth > 1e-3) << x << " " << y;
    deep += depth > 1e-3;
  }
  EXPECT_GT(deep, 20);
  EXPECT_LT(deep, 80);
}

TEST(NegativeMarginFaults, InADockThatFitsExactly) {
  const Polygon dock({{{0, -.5}, {.8, -.5}, {.8, .5}, {0, .5}, {0, .25}, {.6, .25}, {.6, -.25}, {0, -.25}}});
  const Polygon plug = Polygon::box(.6, .5);
  EXPECT_FALSE(collides(dock, plug, at(.301, 0), -0.01));
  EXPECT_TRUE(collides(dock, plug, at(.301, 0), -0.0009));
  for (const double overlap : {1e-6, 1e-3})
    for (int i = 0; i < 50; ++i) {
      const Pose pose = at(.3 + 0.5 * overlap * std::cos(i), 0.5 * overlap * std::sin(i));
      EXPECT_FALSE(collides(dock, plug, pose, -overlap)) << i;
    }
  EXPECT_TRUE(conflicts(dock, still(0, 0), plug, slide(-1, 0, {1.301, 0}), allowing(0.01)).empty());
}

TEST(NegativeMarginFaults, SegmentsThroughBodies) {
  EXPECT_TRUE(collides(Polygon::box(4, 2), Polygon::segment({0, 0.5}, {3, -1.5}), kHere, -0.5));
  EXPECT_TRUE(collides(Polygon::box(4, 2), Polygon::segment({0, 0.5}, {3, -1.5}), kHere, -1 + 1e-12));
  EXPECT_FALSE(collides(Polygon::box(4, 2), Polygon::segment({0, 0.5}, {3, -1.5}), kHere, -1 - 1e-12));
  EXPECT_FALSE(collides(Polygon::segment({-1, 0}, {1, 0}), Polygon::segment({0, -1}, {0, 1}), kHere, -1e-9));
  // Down into the plate, up to a quarter.
  const auto impact = timeOfImpact(Polygon::box(4, 2), still(0, 0), Polygon::segment({-1, 0}, {1, 0}),
                                   slide(0, 2, {0, -2}), allowing(0.25));
  ASSERT_TRUE(impact);
  EXPECT_NEAR(impact->time, 0.625, 1e-5);
  EXPECT_LE(impact->time, 0.625 + 1e-12);
  Random random(11);
  for (int i = 0; i < scaledCount(60); ++i) {
    const Polygon thick(random.coin() ? star(random, 7, 0.5, 1.5) : rectangle(-2, -1, 2, 1));
    const Polygon thin =
        Polygon::segment({random.real(-2, 0), random.real(-2, 2)}, {random.real(0, 2), random.real(-2, 2)});
    Motion motion = slide(random.real(-3, 3), random.real(-3, 3), {random.real(-6, 6), random.real(-6, 6)});
    if (random.coin()) motion.angle = random.real(-3, 3);
    SCOPED_TRACE(i);
    if (random.coin())
      expectDeepTimesWithin(thick, still(0, 0), thin, motion, random.real(0.01, 0.6));
    else
      expectDeepTimesWithin(thin, motion, thick, still(0, 0), random.real(0.01, 0.6));
  }
}

/// Where an edge is used twice, rounding decided.
TEST(NegativeMarginFaults, EdgesUsedTwice) {
  const Polygon a(Ring{{3, -1}, {1, 0}, {1, 3}, {1, 2}, {1, -1}, {-2, -1}, {0, -2}}),
      b(Ring{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}});
  const double truth = depth(a, kHere, b, at(1, 1.75, .8725)).depth;
  EXPECT_NEAR(truth, 0.556705618678877624, 1e-14);
  for (int i = -20; i <= 20; ++i) {
    EXPECT_TRUE(collides(a, b, at(1 + 1e-9 * i, 1.75 - 1e-9 * (i % 3), .8725), -.05)) << i;
    EXPECT_NEAR(depth(a, kHere, b, at(1 + 1e-9 * i, 1.75, .8725)).depth, truth, 2.1e-8) << i;
  }
  Motion turns = Motion::still(at(1, 1.75, .8));
  turns.angle = 0.15;
  turns.shift = Vec2(0.01, -0.01);
  const auto found = conflicts(a, still(0, 0), b, turns, allowing(.05));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].impact.time, 0);
  EXPECT_EQ(found[0].end, 1);
}

TEST(NegativeMarginFaults, MovingBodiesThatAreNotConvex) {
  const Polygon walls({rectangle(-2, -2, 2, 2), rectangle(-1, -1, 1, 1)}),
      body({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}});
  expectDeepTimesWithin(body, still(0, 0), walls, slide(1, 1, {-6, 0}), 0.2);
  Random random(12);
  for (int i = 0; i < scaledCount(60); ++i) {
    Motion motion = slide(random.real(-3, 3), random.real(-3, 3), {random.real(-8, 8), random.real(-8, 8)});
    if (random.oneIn(3)) motion.angle = random.real(-2, 2);
    SCOPED_TRACE(i);
    const Polygon other = random.coin() ? walls : Polygon(star(random, 9, 0.4, 2));
    expectDeepTimesWithin(body, still(0, 0), other, motion, random.real(0.05, 0.5));
  }
}

/// Two jaws that grip a bar, each by less than is allowed: neither a translation nor shrinking frees them.
TEST(NegativeMarginFaults, AGripSlidesAlong) {
  const Polygon jaws({rectangle(-1, 0.4375, 1, 0.625), rectangle(-1, -0.625, 1, -0.4375)}),
      bar({rectangle(-20, -0.5, 20, 0.5)});
  for (const double error : {1e-2, 1e-6, 1e-9, 1e-12}) {
    EXPECT_FALSE(timeOfImpact(bar, still(0, 0), jaws, slide(-9, 0, {18, 0}), allowing(0.0626, error))) << error;
    EXPECT_TRUE(conflicts(bar, still(0, 0), jaws, slide(-9, 0, {18, 0}), allowing(0.0626, error)).empty()) << error;
    const auto found = conflicts(bar, still(0, 0), jaws, slide(-9, 0, {18, 0}), allowing(0.0625, error));
    ASSERT_EQ(found.size(), 1u) << error;
    EXPECT_LE(found[0].impact.time, 1e-11);
    EXPECT_EQ(found[0].end, 1);
  }
}

TEST(NegativeMarginFaults, TwoComplementsAlwaysCollide) {
  const Polygon a = Polygon({rectangle(0, 0, 1, 1)}).complement(), b = Polygon({rectangle(0, 2, 1, 3)}).complement();
  for (const double margin : {0.0, -1e-9, -1.0, -1e300, 1.0})
    for (const Touching touching : {Touching::Collides, Touching::Allowed})
      EXPECT_TRUE(collides(a, b, kHere, margin, touching)) << margin;
  const double least = signedDistance(a, kHere, b, kHere).distance;
  EXPECT_TRUE(std::isinf(least) && least < 0);
}

/// A true answer stays true as the margin grows, through 0.
TEST(NegativeMarginFaults, IsMonotoneThroughZero) {
  const std::vector<double> margins{-1e300, -0.51, -0.5, -0.25, -1e-300, -5e-324, 0, 5e-324, 1e-300, 0.25, 1e300};
  const std::vector<Polygon> inner = {Polygon::point({0.5, 0}), Polygon::segment({-3, 0.5}, {3, 0.5}),
                                      Polygon::segment({0.5, 0}, {9, 9}), Polygon::box(0.5, 0.5)};
  for (const Polygon& thin : inner) {
    bool before = false, open_before = false;
    for (const double margin : margins) {
      const bool now = collides(Polygon::box(2, 2), thin, kHere, margin),
                 open = collides(Polygon::box(2, 2), thin, kHere, margin, Touching::Allowed);
      EXPECT_GE(now, before) << margin;
      EXPECT_GE(open, open_before) << margin;
      EXPECT_GE(now, open) << margin;
      before = now, open_before = open;
    }
    EXPECT_TRUE(open_before);
    EXPECT_TRUE(collides(Polygon::box(2, 2), thin, kHere, 0, Touching::Allowed));
  }
  EXPECT_FALSE(collides(Polygon::box(2, 2), Polygon::point({1, 0}), kHere, 0, Touching::Allowed));
  EXPECT_FALSE(collides(Polygon::box(2, 2), Polygon::segment({-1, 1}, {1, 1}), kHere, 0, Touching::Allowed));
  EXPECT_FALSE(
      collides(Polygon::segment({-1, 0}, {1, 0}), Polygon::segment({0, -1}, {0, 1}), kHere, 0, Touching::Allowed));
  EXPECT_TRUE(collides(Polygon::segment({-1, 0}, {1, 0}), Polygon::segment({0, -1}, {0, 1}), kHere, 0));
}

TEST(NegativeMarginFaults, WhatTheMeasureSaysOfWalls) {
  // Crossing bars: true in 0.3.
  EXPECT_FALSE(collides(Polygon::box(4, 0.1), Polygon::box(0.1, 4), kHere, -0.06));
  EXPECT_TRUE(collides(Polygon::box(4, 0.1), Polygon::box(0.1, 4), kHere, -0.05));
  // A thin wall through a robot is as deep as the robot.
  EXPECT_TRUE(collides(Polygon::box(0.01, 10), Polygon::box(1, 1), kHere, -0.49));
  EXPECT_FALSE(collides(Polygon::box(0.01, 10), Polygon::box(1, 1), kHere, -0.51));
  // Ten slabs in a scene are no wall: each pair is asked for itself.
  Scene slabs, wall;
  const Polygon slab = Polygon::box(0.02, 1), speck = Polygon::box(0.15, 0.15);
  for (int i = 0; i < 10; ++i) slabs.add(slab, at(0.02 * i - 0.09, 0));
  wall.add(Polygon::box(0.2, 1), kHere);
  EXPECT_FALSE(slabs.collides(Polygon::box(0.15, 1), at(0, 0), {-0.08, 0}));
  EXPECT_TRUE(wall.collides(Polygon::box(0.15, 1), at(0, 0), {-0.08, 0}));
  EXPECT_TRUE(slabs.collides(speck, at(0, 0), {-0.07, 0}));
}

/// Margins add up, and the sum decides: a disc of 0.3 with -0.001 is at 0.299.
TEST(NegativeMarginFaults, MarginsAddUp) {
  Scene scene;
  BodyOptions disc, less;
  disc.margin = 0.3;
  less.margin = -0.001;
  scene.add(Polygon::point({0, 0}), kHere, disc);
  const Scene::Body plate = scene.add(Polygon::box(2, 2), at(1.2995, 0), less);
  EXPECT_TRUE(scene.collisions().empty());
  scene.move(plate, at(1.2985, 0));
  EXPECT_EQ(scene.collisions().size(), 1u);
  EXPECT_FALSE(scene.collides(Polygon::box(2, 2), at(-1.2995, 0), {-0.001, 0}));
  EXPECT_TRUE(scene.collides(Polygon::box(2, 2), at(-1.2985, 0), {-0.001, 0}));
}

/// Found by the soak: pieces of an outline that lie within the other region, but no deeper than rounding tells, touch
/// no edge of it: their search asked for the direction of an edge that there isn't.
TEST(NegativeMarginFaults, APieceWithinTheRegionHasADirectionWithoutAnEdge) {
  const Polygon a({{{0x1.a239dff4cfcd8p-2, 0x1.8fef4206de0a5p-4},
                    {-0x1.420e05065e1b5p-2, 0x1.1cf081d2bcebep-2},
                    {-0x1.fa97d5dcdf7f5p-3, -0x1.9dd03b9b16043p-5},
                    {-0x1.7113a1ad02c7fp-3, -0x1.846490b9826cfp-2},
                    {-0x1.711111b2020e4p-3, -0x1.8464e2abe95b1p-2},
                    {-0x1.710e81b70154ap-3, -0x1.8465349e50493p-2},
                    {-0x1.710e81b6b823cp-3, -0x1.8465349e32a2bp-2},
                    {-0x1.710e81b66ef2fp-3, -0x1.8465349e14fc1p-2}}},
                  FillRule::NonZero);
  const Polygon b({{{-0.75, 1}, {0.25, -1}, {0.75, 0}, {-0.25, 0.5}}}, FillRule::NonZero);
  Motion way_a, way_b;
  way_a.start = pose(-0x1.c2b079c100784p-1, -0x1.e5e4b6dcee9bcp-2, 0x1.37616faf62ec5p+17, 0x1.e5e4b6dcee9bcp-2,
                     -0x1.c2b079c100784p-1, -0x1.1d362f2fd969p+17);
  way_a.shift = {0x1.7bfb7e4653d77p-4, -0x1.eb10b1aea42a4p-5};
  way_a.angle = 0x1.39529d9517ac8p+4;
  way_a.pivot = {-0x1.d747eae4f4858p-6, -0x1.28dbae7afbdap-10};
  way_b.start.translation() = Vec2(0x1.37636eab0824cp+17, -0x1.1d361a8aaeea3p+17);
  way_b.shift = {-0x1.8d39e261b6ce8p+3, 0x1.628c8381f32eep+1};
  ImpactOptions options;
  options.margin = -0x1.c70dc6a293ff3p-18;
  options.time_error = 0x1.7397b3ea2affbp-30;
  const auto impact = timeOfImpact(a, way_a, b, way_b, options);
  ASSERT_TRUE(impact);
  const Pose then_a = way_a.at(impact->time), then_b = way_b.at(impact->time);
  EXPECT_TRUE(collide(a, then_a, b, then_b, {options.margin + 1e-7, 0}));
  for (const double share : {0.1, 0.5, 0.9, 0.99})
    EXPECT_FALSE(collide(a, way_a.at(share * impact->time), b, way_b.at(share * impact->time), {options.margin, 0}));
}

/// Found by the soak: a point that is on an edge but for rounding, and less than rounding is allowed. Its pieces said
/// otherwise than the pair.
TEST(NegativeMarginFaults, AtTheStartRoundingDecidesForTimesOfImpactAsForCollide) {
  Random random(1);
  int deep = 0, shallow = 0;
  for (int i = 0; i < scaledCount(2000); ++i) {
    const Polygon ring({star(random, random.integer(3, 9), 0.3, 1)});
    const Pose pose_a = turnedAndMoved(random.real(0, 6), random.real(-9, 9), random.real(-9, 9));
    const EdgeIndex edge = random.integer(0, static_cast<int>(ring.edgeCount()) - 1);
    const Vec2 on = ring.edgeStart(edge) + random.unit() * (ring.edgeEnd(edge) - ring.edgeStart(edge));
    const Pose pose_b = at((pose_a * on).x(), (pose_a * on).y());
    const double margin = random.coin() ? -5e-324 : -std::pow(10, random.real(-20, -14));
    const Motion rests = Motion::still(pose_a), moves = Motion::translation(pose_b, {random.real(-1, 1), 0});
    const bool is_deep = collide(ring, pose_a, Polygon::point({0, 0}), pose_b, {margin, 0});
    ImpactOptions options;
    options.margin = margin;
    const auto moving = timeOfImpact(ring, rests, Polygon::point({0, 0}), moves, options);
    const auto still = timeOfImpact(ring, rests, Polygon::point({0, 0}), Motion::still(pose_b), options);
    EXPECT_EQ(moving && moving->time == 0, is_deep) << i;
    EXPECT_EQ(still && still->time == 0, is_deep) << i;
    ++(is_deep ? deep : shallow);
  }
  EXPECT_GE(std::min(deep, shallow), scaledCount(2000) / 5);
}

// At rest the quotient of precision and speed was 0 / 0, which timeOfImpact() refused as its own time error.
TEST(NegativeMarginFaults, OfBodiesAtRestThatAreAsSmallAsDoublesGo) {
  for (const double size : {5e-324, 5e-323, 1e-320, 1e-315, 1e-310, 1e-300}) {
    const double s = 8 * size;
    const Polygon a({rectangle(-s, -s, s, s)}), b({{{0, 0}, {s, 0}, {s, s}, {s / 2, s / 2}, {0, s}}});
    const Motion at = Motion::still(turnedAndMoved(0, -2 * s, 0));
    EXPECT_FALSE(timeOfImpact(a, Motion::still(Pose::Identity()), b, at, {-size, 1e-3})) << size;
    const Motion through = Motion::translation(turnedAndMoved(0, -2 * s, 0), {3 * s, 0});
    EXPECT_TRUE(timeOfImpact(a, Motion::still(Pose::Identity()), b, through, {-size, 1e-3})) << size;
  }
}

}  // namespace
}  // namespace tricover::support
