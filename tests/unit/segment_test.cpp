// SPDX-License-Identifier: BSD-3-Clause
// Points and segments as polygons, discs and stadiums by their margins; signed distances known by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "limited_distance.h"
#include "refusal.h"
#include "shapes.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/locate.h"
#include "tricover/polygon.h"
#include "tricover/signed_distance.h"
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
  EXPECT_FALSE(distance > 0 && within(a, b, nudged(distance, -1))) << distance;
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
  const Polygon s = Polygon::segment({1, 2}, {5, 2});
  EXPECT_EQ(locate(s, {3, 2}), Location::Boundary);
  EXPECT_EQ(locate(s, {5, 2}), Location::Boundary);
  EXPECT_EQ(locate(s, {nudged(5, 1), 2}), Location::Outside);
  EXPECT_EQ(locate(s, {3, nudged(2, 1)}), Location::Outside);
  const Polygon p = Polygon::point({1, 2});
  EXPECT_EQ(locate(p, {1, 2}), Location::Boundary);
  EXPECT_EQ(locate(p, {1, nudged(2, 1)}), Location::Outside);
  EXPECT_EQ(p.coveringOrigin(), Vec2(1, 2));
}

TEST(Segment, OfEqualEndsIsTheirPoint) {
  const Polygon s = Polygon::segment({1, 2}, {1, 2}), p = Polygon::point({1, 2});
  EXPECT_EQ(s.rings(), p.rings());
  EXPECT_TRUE(within(s, p, 0));
  EXPECT_FALSE(within(s, Polygon::point({1, 3}), nudged(1, -1)));
}

TEST(Segment, RefusesWhatIsNotFinite) {
  EXPECT_EQ(refusal([] { Polygon::point({NAN, 0}); }), "tricover: p: a coordinate is not finite");
  EXPECT_EQ(refusal([] { Polygon::segment({0, kInfinity}, {0, 0}); }), "tricover: p: a coordinate is not finite");
  EXPECT_EQ(refusal([] { Polygon::segment({0, 0}, {0, -kInfinity}); }), "tricover: q: a coordinate is not finite");
}

TEST(Margin, OfPointsIsADisc) {
  for (const double unit : {1.0, 0x1p-1000, 0x1p1000, 0x1p-1070}) {
    const Polygon p = Polygon::point(unit * Vec2(1, 1)), q = Polygon::point(unit * Vec2(4, 5));
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
  const Polygon rings({ring, ring}), p = Polygon::point({-2, -2});
  for (const double margin : {4.0, 1e300}) EXPECT_TRUE(within(rings, p, margin)) << margin;
  EXPECT_FALSE(within(rings, p, 2));
  EXPECT_EQ(gap(rings, p, 2, 0).distance, gap(Polygon::point({-4, -4}), p, 2, 0).distance);
}

TEST(Margin, OfASegmentIsAStadium) {
  const Polygon s = Polygon::segment({0, 0}, {8, 0});
  expectApart(s, Polygon::point({4, 3}), 3);
  expectApart(s, Polygon::point({-3, 4}), 5);
  expectApart(s, Polygon::point({11, -4}), 5);
  expectApart(s, Polygon::segment({2, -1}, {3, 1}), 0);
  expectApart(s, Polygon::segment({8, 0}, {9, 1}), 0);
  expectApart(s, Polygon::segment({2, 1}, {3, 2}), 1);
}

/// A frame whose hole has a radius of 3 around the origin.
Polygon frame() { return Polygon({rectangle(-5, -5, 5, 5), rectangle(-3, -3, 3, 3)}); }

TEST(Margin, OfAPointBesideAPolygon) {
  const Polygon f = frame();
  expectApart(f, Polygon::point({0, 0}), 3);  // in the hole
  EXPECT_EQ(gap(f, Polygon::point({1, 0}), 0.5).distance, 1.5);
  EXPECT_EQ(gap(f, Polygon::point({4, 0.5}), 1).distance, 0);
  for (const Vec2& p : {Vec2(4, 0.5), Vec2(5, 2), Vec2(-5, -5)})
    expectApart(f, Polygon::point(p), 0);  // inside, on the outline
  EXPECT_FALSE(within(f, Polygon::point({nudged(5, 1), 2}), 0));
  expectApart(f, Polygon::segment({0, 0}, {4, 0}), 0);
  expectApart(f, Polygon::segment({-1, 0}, {1, 0}), 2);
  expectApart(f, Polygon::segment({-9, -9}, {9, 9}), 0);  // longer than the polygon is large
  EXPECT_EQ(gap(f, Polygon::segment({-9, 9}, {9, 9}), 1).distance, 3);
}

/// Squares of the place in the polygon's units would overflow a float's range, or its place a double's.
TEST(Margin, OfAPointFarFromATinyPolygon) {
  for (const double tiny : {1e-16, 1e-18, 1e-19, 1e-20, 1e-21, 1e-23, 1e-40, 1e-300}) {
    const Polygon a({{{-tiny, -tiny}, {tiny, -tiny}, {tiny, tiny}, {-tiny, tiny}, {0, tiny / 2}}});
    for (const double turn : {0.0, 0.3}) {
      const Pose turned = turnedAndMoved(turn, 0, 0);
      EXPECT_NEAR(distance(a, turned, Polygon::point({3, 4}), kHere).distance, 5, 1e-14) << tiny;
      EXPECT_NEAR(distance(a, turned, Polygon::point({3, 4}), kHere, DistanceOptions{1}).distance, 4, 1e-14) << tiny;
    }
  }
  const Polygon a({{{-1e-300, 0}, {1e-300, 0}, {0, 1e-300}}});
  EXPECT_FALSE(within(a, Polygon::point({1e300, 0}), 1e-200));
  EXPECT_TRUE(within(a, Polygon::point({1e300, 0}), 1e301));
}

TEST(Margin, OfADistanceKeepsPointsAndEdgesOfTheRegions) {
  const Polygon square({rectangle(0, 0, 4, 4)});
  for (const double margin : {1.0, 10.0}) {
    const DistanceResult found = gap(square, Polygon::point({7, 1}), margin);
    EXPECT_EQ(found.distance, margin == 1 ? 2 : 0);
    EXPECT_EQ(found.point_a, Vec2(4, 1));
    EXPECT_EQ(found.point_b, Vec2(7, 1));
    EXPECT_EQ(found.edge_a, 1);
    EXPECT_EQ(found.edge_b, 0);
  }
  const DistanceResult inside = gap(square, Polygon::point({1, 2}), 10);
  EXPECT_EQ(inside.distance, 0);
  EXPECT_EQ(inside.point_a, inside.point_b);
}

TEST(Margin, CountsBeforeTheLimit) {
  const Polygon square({rectangle(0, 0, 4, 4)}), away({rectangle(7, 0, 9, 4)});
  for (const Polygon& other : {away, Polygon::point({7, 1}), Polygon::segment({7, 1}, {8, 3})}) {
    EXPECT_EQ(gap(square, other, 1, 2).distance, 2);
    EXPECT_EQ(gap(square, other, 1, nudged(2, -1)).distance, kInfinity);
    EXPECT_EQ(gap(square, other, 3, 0).distance, 0);
    EXPECT_EQ(gap(square, other, nudged(3, -1), 0).distance, kInfinity);
    EXPECT_EQ(gap(square, other, 1, nudged(2, -1)).edge_a, -1);
  }
}

TEST(Margin, OfADistanceMustBeFiniteAndNotNegative) {
  const Polygon p = Polygon::point({0, 0});
  for (const double margin : {-1.0, kInfinity, double{NAN}})
    EXPECT_THROW(distance(p, kHere, p, kHere, DistanceOptions{margin}), std::invalid_argument) << margin;
}

TEST(Margin, MakesDiscsMeetInTime) {
  const Polygon p = Polygon::point({0, 0});
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

double signedAt(const Polygon& a, const Polygon& b, const Vec2& at, double margin = 0) {
  DistanceOptions options;
  options.margin = margin;
  return signedDistance(a, kHere, b, tricover::poseAt(at.x(), at.y()), options).distance;
}

struct Row {
  Polygon a, b;
  Vec2 at;
  double margin, distance;
  double error = 0;
};

void expectDistances(const std::vector<Row>& rows) {
  for (const Row& row : rows)
    EXPECT_NEAR(signedAt(row.a, row.b, row.at, row.margin), row.distance, row.error) << &row - rows.data();
}

TEST(SignedDistance, ByHand) {
  const Polygon square = Polygon::box(4, 4), plate = Polygon::box(2, 4), dot = Polygon::point({0, 0}),
                rod = Polygon::segment({0, -1}, {0, 1});
  expectDistances({
      {square, square, {5, 1}, 0, 1},
      {square, square, {7, 8}, 0, 5},
      {square, square, {4, 1}, 0, 0},
      {square, square, {4, 4}, 0, 0},
      {square, square, {3.5, 1}, 0, -0.5, 1e-14},
      {square, square, {0, 0}, 0, -2, 1e-14},
      // Margins are subtracted from either.
      {square, square, {7, 8}, 1, 4},
      {square, square, {7, 8}, 5, 0},
      {square, square, {7, 8}, 6, -1},
      {square, square, {4, 1}, 0.5, -0.5},
      {square, square, {3.5, 1}, 0.25, -0.75, 1e-14},
      {square, dot, {3, 0}, 1, 0},
      {plate, dot, {0.75, 0}, 0, -0.25, 1e-14},
      {plate, dot, {1, 0}, 0, 0},
      {plate, rod, {3, 1}, 0, 2},
      {plate, rod, {0.5, 0}, 0, -0.5, 1e-14},
      {dot, dot, {0, 0}, 0, 0},
      {rod, rod, {0, 0.5}, 0, 0},
      {rod, dot, {3, 5}, 0, 5},
  });
  // A disc in a box, a rounding beside its margin.
  EXPECT_GT(signedAt(square, dot, {nudged(3, 1), 0}, 1), 0);
  EXPECT_LT(signedAt(square, dot, {nudged(3, -1), 0}, 1), 0);
  const SignedDistance touch = signedDistance(square, kHere, square, tricover::poseAt(4, 1));
  EXPECT_NEAR(touch.normal.x(), 1, 1e-12);
  EXPECT_EQ(touch.edge_a, 1);
  EXPECT_EQ(touch.edge_b, 3);
  EXPECT_NEAR(signedDistance(plate, kHere, dot, tricover::poseAt(0.75, 0)).normal.x(), 1, 1e-12);
}

TEST(SignedDistance, OfRegionsThatAreNotConvex) {
  const Polygon frame({rectangle(-5, -5, 5, 5), rectangle(-3, -3, 3, 3)});
  const Polygon slot({{{-3, -3}, {3, -3}, {3, 3}, {1, 3}, {1, 0}, {-1, 0}, {-1, 3}, {-3, 3}}});
  expectDistances({
      {frame, Polygon::box(2, 2), {0, 0}, 0, 2},
      {frame, Polygon::box(2, 2), {2, 0}, 0, 0},
      {frame, Polygon::box(2, 2), {2.5, 0}, 0, -0.5, 1e-11},
      // A peg that fits its slot exactly is nowhere deep, and into both walls of its corner it is by the diagonal.
      {slot, Polygon::box(2, 2), {0, 1.5}, 0, 0},
      {slot, Polygon::box(2, 2), {0, 1}, 0, 0},
      {slot, Polygon::box(2, 2), {0.25, 0.75}, 0, -0.25 * std::sqrt(2), 1e-14},
  });
  EXPECT_GT(signedAt(slot, Polygon::box(1.75, 1.75), {0, 1.5}), 0.1);
}

TEST(SignedDistance, OfAnySize) {
  for (const double size : {1e-300, 1e-150, 1e-10, 1e10, 1e150, 1e290}) {
    const Polygon square = Polygon::box(4, 4).scaled(size);
    EXPECT_NEAR(signedAt(square, square, Vec2(7, 8) * size) / size, 5, 1e-13) << size;
    EXPECT_NEAR(signedAt(square, square, Vec2(3.5, 1) * size) / size, -0.5, 1e-13) << size;
    EXPECT_NEAR(signedAt(square, square, Vec2(3.5, 1) * size, size) / size, -1.5, 1e-13) << size;
  }
}

TEST(SignedDistance, OfPointsFarFromEachOther) {
  for (int exponent = -1000; exponent <= 1000; exponent += 4) {
    const double far = std::ldexp(1, exponent);
    const SignedDistance s = signedDistance(Polygon::point({-far, far}), kHere, Polygon::point({0, 0}), kHere);
    EXPECT_NEAR(s.normal.x(), std::sqrt(0.5), 1e-15) << exponent;
    EXPECT_NEAR(s.normal.y(), -std::sqrt(0.5), 1e-15) << exponent;
    EXPECT_NEAR(s.distance / far, std::sqrt(2), 1e-15) << exponent;
  }
}

TEST(SignedDistance, OfComplements) {
  const Polygon lot = Polygon::box(20, 10).complement(), car = Polygon::box(2, 1);
  const auto at = [&](double x, double y) { return signedDistance(lot, kHere, car, tricover::poseAt(x, y)).distance; };
  EXPECT_EQ(at(0, 0), 4.5);
  EXPECT_EQ(at(0, 4.5), 0);
  EXPECT_EQ(at(3, 4.75), -0.25);
  EXPECT_NEAR(at(9.25, 4.75), -0.25 * std::sqrt(2), 1e-14);
  EXPECT_EQ(signedDistance(lot, kHere, lot, kHere).distance, -kInfinity);
}

TEST(SignedDistance, AllowsErrors) {
  const Polygon disc({regular(500, 1)}), hole({regular(500, 4), regular(500, 3)});
  const double exact = signedAt(disc, hole, {0.25, 0.125});
  DistanceOptions options;
  options.relative_error = 0.1;
  const double near = signedDistance(disc, kHere, hole, tricover::poseAt(0.25, 0.125), options).distance;
  EXPECT_GE(near, exact * (1 - 1e-14));
  EXPECT_LE(near, exact * 1.1);
}

TEST(SignedDistance, RefusesWhatDistanceRefuses) {
  const Polygon square = Polygon::box(1, 1);
  Pose skewed = kHere;
  skewed.linear()(0, 0) = 2;
  const auto expectNamed = [&](const char* name, const Pose& pose, const DistanceOptions& options) {
    const std::string text = refusal([&] { signedDistance(square, kHere, square, pose, options); });
    EXPECT_NE(text.find(name), std::string::npos) << text;
  };
  expectNamed("pose_b", skewed, {});
  for (const double margin : {HUGE_VAL, std::nan("")}) expectNamed("margin", kHere, {margin});
  expectNamed("relative_error", kHere, {0, -1});
}

}  // namespace
}  // namespace tricover::support
