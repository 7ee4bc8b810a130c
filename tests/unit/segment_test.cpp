// SPDX-License-Identifier: BSD-3-Clause
// Points and segments as polygons, discs and stadiums by their margins.
#include "tricover/segment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "limited_distance.h"
#include "refusal.h"
#include "shapes.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/locate.h"
#include "tricover/time_of_impact.h"

namespace tricover::support {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Pose kHere = Pose::Identity();

bool within(const Polygon& a, const Polygon& b, double margin) {
  const bool answer = collide(a, kHere, b, kHere, {margin});
  EXPECT_EQ(collide(b, kHere, a, kHere, {margin}), answer);
  return answer;
}

/// At that distance, and not a rounding nearer.
void expectApart(const Polygon& a, const Polygon& b, double distance) {
  EXPECT_TRUE(within(a, b, distance)) << distance;
  if (distance > 0) EXPECT_FALSE(within(a, b, nudged(distance, -1))) << distance;
}

DistanceResult gap(const Polygon& a, const Polygon& b, double margin, double limit = kInfinity) {
  LimitedOptions options;
  options.margin = margin;
  options.limit = limit;
  const DistanceResult result = distance(a, kHere, b, kHere, options);
  EXPECT_EQ(distance(b, kHere, a, kHere, options).distance, result.distance);
  return result;
}

TEST(Segment, IsExactlyItsPoints) {
  const Polygon s = segment({1, 2}, {5, 2});
  EXPECT_EQ(locate(s, {3, 2}), Location::Boundary);
  EXPECT_EQ(locate(s, {5, 2}), Location::Boundary);
  EXPECT_EQ(locate(s, {nudged(5, 1), 2}), Location::Outside);
  EXPECT_EQ(locate(s, {3, nudged(2, 1)}), Location::Outside);
  const Polygon p = point({1, 2});
  EXPECT_EQ(locate(p, {1, 2}), Location::Boundary);
  EXPECT_EQ(locate(p, {1, nudged(2, 1)}), Location::Outside);
  EXPECT_EQ(p.origin(), Vec2(1, 2));
}

TEST(Segment, OfEqualEndsIsTheirPoint) {
  const Polygon s = segment({1, 2}, {1, 2}), p = point({1, 2});
  EXPECT_EQ(s.rings(), p.rings());
  EXPECT_TRUE(within(s, p, 0));
  EXPECT_FALSE(within(s, point({1, 3}), nudged(1, -1)));
}

TEST(Segment, RefusesWhatIsNotFinite) {
  EXPECT_EQ(refusal([] { point({NAN, 0}); }), "tricover: p: a coordinate is not finite");
  EXPECT_EQ(refusal([] { segment({0, kInfinity}, {0, 0}); }), "tricover: p: a coordinate is not finite");
  EXPECT_EQ(refusal([] { segment({0, 0}, {0, -kInfinity}); }), "tricover: q: a coordinate is not finite");
}

TEST(Margin, OfPointsIsADisc) {
  for (const double unit : {1.0, 0x1p-1000, 0x1p1000, 0x1p-1070}) {
    const Polygon p = point(unit * Vec2(1, 1)), q = point(unit * Vec2(4, 5));
    expectApart(p, q, 5 * unit);
    EXPECT_EQ(gap(p, q, 5 * unit).distance, 0) << unit;
    EXPECT_GT(gap(p, q, nudged(5 * unit, -1)).distance, 0) << unit;
    EXPECT_EQ(gap(p, q, 2 * unit).distance, 3 * unit) << unit;
    EXPECT_EQ(gap(p, q, 7 * unit).distance, 0) << unit;
  }
}

// Its unit is so small that squares of a distance in it overflow.
TEST(Margin, OfAPointBesideAPolygonWithoutExtent) {
  const Ring ring{{-4, -4}, {-4, -4}, {-4, -4}};
  const Polygon rings({ring, ring}), p = point({-2, -2});
  for (const double margin : {4.0, 1e300}) EXPECT_TRUE(within(rings, p, margin)) << margin;
  EXPECT_FALSE(within(rings, p, 2));
  EXPECT_EQ(gap(rings, p, 2, 0).distance, gap(point({-4, -4}), p, 2, 0).distance);
}

TEST(Margin, OfASegmentIsAStadium) {
  const Polygon s = segment({0, 0}, {8, 0});
  expectApart(s, point({4, 3}), 3);
  expectApart(s, point({-3, 4}), 5);
  expectApart(s, point({11, -4}), 5);
  expectApart(s, segment({2, -1}, {3, 1}), 0);
  expectApart(s, segment({8, 0}, {9, 1}), 0);
  expectApart(s, segment({2, 1}, {3, 2}), 1);
}

/// A frame whose hole has a radius of 3 around the origin.
Polygon frame() { return Polygon({rectangle(-5, -5, 5, 5), rectangle(-3, -3, 3, 3)}); }

TEST(Margin, OfAPointBesideAPolygon) {
  const Polygon f = frame();
  expectApart(f, point({0, 0}), 3);  // in the hole
  EXPECT_EQ(gap(f, point({1, 0}), 0.5).distance, 1.5);
  EXPECT_EQ(gap(f, point({4, 0.5}), 1).distance, 0);
  for (const Vec2& p : {Vec2(4, 0.5), Vec2(5, 2), Vec2(-5, -5)}) expectApart(f, point(p), 0);  // inside, on the outline
  EXPECT_FALSE(within(f, point({nudged(5, 1), 2}), 0));
  expectApart(f, segment({0, 0}, {4, 0}), 0);
  expectApart(f, segment({-1, 0}, {1, 0}), 2);
  expectApart(f, segment({-9, -9}, {9, 9}), 0);  // longer than the polygon is large
  EXPECT_EQ(gap(f, segment({-9, 9}, {9, 9}), 1).distance, 3);
}

/// Squares of the place in the polygon's units would overflow a float's range, or its place a double's.
TEST(Margin, OfAPointFarFromATinyPolygon) {
  for (const double tiny : {1e-16, 1e-18, 1e-19, 1e-20, 1e-21, 1e-23, 1e-40, 1e-300}) {
    const Polygon a({{{-tiny, -tiny}, {tiny, -tiny}, {tiny, tiny}, {-tiny, tiny}, {0, tiny / 2}}});
    for (const double turn : {0.0, 0.3}) {
      const Pose turned = turnedAndMoved(turn, 0, 0);
      EXPECT_NEAR(distance(a, turned, point({3, 4}), kHere).distance, 5, 1e-14) << tiny;
      EXPECT_NEAR(distance(a, turned, point({3, 4}), kHere, DistanceOptions{1}).distance, 4, 1e-14) << tiny;
    }
  }
  const Polygon a({{{-1e-300, 0}, {1e-300, 0}, {0, 1e-300}}});
  EXPECT_FALSE(within(a, point({1e300, 0}), 1e-200));
  EXPECT_TRUE(within(a, point({1e300, 0}), 1e301));
}

TEST(Margin, OfADistanceKeepsPointsAndEdgesOfTheRegions) {
  const Polygon square({rectangle(0, 0, 4, 4)});
  for (const double margin : {1.0, 10.0}) {
    const DistanceResult found = gap(square, point({7, 1}), margin);
    EXPECT_EQ(found.distance, margin == 1 ? 2 : 0);
    EXPECT_EQ(found.point_a, Vec2(4, 1));
    EXPECT_EQ(found.point_b, Vec2(7, 1));
    EXPECT_EQ(found.edge_a, 1);
    EXPECT_EQ(found.edge_b, 0);
  }
  const DistanceResult inside = gap(square, point({1, 2}), 10);
  EXPECT_EQ(inside.distance, 0);
  EXPECT_EQ(inside.point_a, inside.point_b);
}

TEST(Margin, CountsBeforeTheLimit) {
  const Polygon square({rectangle(0, 0, 4, 4)}), away({rectangle(7, 0, 9, 4)});
  for (const Polygon& other : {away, point({7, 1}), segment({7, 1}, {8, 3})}) {
    EXPECT_EQ(gap(square, other, 1, 2).distance, 2);
    EXPECT_EQ(gap(square, other, 1, nudged(2, -1)).distance, kInfinity);
    EXPECT_EQ(gap(square, other, 3, 0).distance, 0);
    EXPECT_EQ(gap(square, other, nudged(3, -1), 0).distance, kInfinity);
    EXPECT_EQ(gap(square, other, 1, nudged(2, -1)).edge_a, -1);
  }
}

TEST(Margin, OfADistanceMustBeFiniteAndNotNegative) {
  const Polygon p = point({0, 0});
  for (const double margin : {-1.0, kInfinity, double{NAN}})
    EXPECT_THROW(distance(p, kHere, p, kHere, DistanceOptions{margin}), std::invalid_argument) << margin;
}

TEST(Margin, MakesDiscsMeetInTime) {
  const Polygon p = point({0, 0});
  const ImpactOptions options{1, 1e-12};
  const auto fly = [&](double y) {
    return timeOfImpact(p, Motion(), p, Motion::translation(turnedAndMoved(0, 10, y), {-18, 0}), options);
  };
  const auto impact = fly(0);
  ASSERT_TRUE(impact);
  EXPECT_NEAR(impact->time, 0.5, 1e-12);
  EXPECT_LE(impact->time, 0.5);
  EXPECT_EQ(impact->edge_a, 0);
  EXPECT_EQ(impact->edge_b, 0);
  EXPECT_FALSE(fly(nudged(1, 4096)));
}

}  // namespace
}  // namespace tricover::support
