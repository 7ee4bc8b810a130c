// SPDX-License-Identifier: BSD-3-Clause
// Distances worked out by hand, at every size; holes, containment, options, refusals, and what a cache keeps.
#include "tricover/distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "limited_distance.h"
#include "polygon/cache_access.h"
#include "random.h"
#include "refusal.h"
#include "shapes.h"
#include "tricover/collide.h"
#include "tricover/segment.h"

namespace tricover::support {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Polygon square(double size) { return Polygon({scaled(rectangle(0, 0, 1, 1), size)}); }

Pose at(double x, double y) { return turnedAndMoved(0, x, y); }

/// Between the corners (1, 1) and (4, 5).
TEST(Distance, ThreeFourFiveAtEverySize) {
  for (const int exponent : {-1070, -1000, -498, -30, 0, 30, 498, 1000, 1020}) {
    const double unit = std::ldexp(1, exponent);
    const Polygon a = square(unit);
    const DistanceResult r = distance(a, at(0, 0), a, at(4 * unit, 5 * unit));
    EXPECT_EQ(r.distance, 5 * unit) << exponent;
    EXPECT_EQ(r.point_a, Vec2(unit, unit)) << exponent;
    EXPECT_EQ(r.point_b, Vec2(4 * unit, 5 * unit)) << exponent;
  }
}

TEST(Distance, EdgeToVertexAndEdgeToEdge) {
  const Polygon a = square(1), diamond({{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}});
  const DistanceResult r = distance(a, at(0, 0), diamond, at(0.25, 5));
  EXPECT_EQ(r.distance, 3);
  EXPECT_EQ(r.point_a, Vec2(0.25, 1));
  EXPECT_EQ(r.point_b, Vec2(0.25, 4));
  EXPECT_EQ(r.edge_a, 2);
  EXPECT_TRUE(r.edge_b == 0 || r.edge_b == 3);
  const DistanceResult parallel = distance(a, at(0, 0), a, at(3, 0.5));
  EXPECT_EQ(parallel.distance, 2);
  EXPECT_EQ(parallel.point_a.x(), 1);
  EXPECT_EQ(parallel.point_b.x(), 3);
  EXPECT_EQ(parallel.point_a.y(), parallel.point_b.y());
}

/// Two regions that are one point each, the same one: there is no edge to divide by.
TEST(Distance, OfTwoPolygonsThatAreOnePoint) {
  const Polygon a({Ring(3, Vec2(0, 0))}), b({Ring(3, Vec2(0, 0))});
  for (const DistanceResult& r : {distance(a, at(0, 0), b, at(0, 0)), distance(a, at(0, 0), a, at(0, 0))}) {
    EXPECT_EQ(r.distance, 0);
    EXPECT_EQ(r.point_a, Vec2(0, 0));
    EXPECT_EQ(r.point_b, Vec2(0, 0));
  }
  EXPECT_EQ(distance(a, at(0, 0), b, at(3, 4)).distance, 5);
  // Far off, too, where what is scaled by their size would overflow.
  const Pose far = at(0x1p354, -0x1p353);
  const DistanceResult same = distance(a, far, b, far);
  EXPECT_EQ(same.distance, 0);
  EXPECT_EQ(same.point_a, far.translation());
  EXPECT_EQ(same.point_b, far.translation());
}

/// A gap of one unit in the last place, and of far less than that of any coordinate.
TEST(Distance, GapsBelowRounding) {
  const Polygon a = square(1);
  EXPECT_EQ(distance(a, at(0, 0), a, at(nudged(1, 1), 0)).distance, 0x1p-52);
  EXPECT_EQ(distance(a, at(0, 0), a, at(1, 0)).distance, 0);
  // The right edge of `left` is at 1 - 2^-60 in the world, which no double is.
  const Polygon left({rectangle(-1, 0, -0x1p-60, 1)});
  EXPECT_EQ(distance(left, at(1, 0), a, at(1, 0)).distance, 0x1p-60);
  // y = 2^-70 x, against the axis: a shear that is far below what rounding would show.
  Pose sheared = at(0, 0);
  sheared.linear()(1, 0) = 0x1p-70;
  const Polygon above({rectangle(1, 0, 2, 1)}), below({rectangle(1, -1, 2, 0)});
  EXPECT_EQ(distance(above, sheared, below, at(0, 0)).distance, 0x1p-70);
}

TEST(Distance, FarFromTheOriginAndOverflow) {
  const Polygon a = square(1);
  EXPECT_EQ(distance(a, at(1e15, -1e15), a, at(1e15 + 4, -1e15 + 5)).distance, 5);
  const Polygon huge = square(1e308);
  const DistanceResult r = distance(huge, at(-1.7e308, 0), huge, at(1.7e308, 0));
  EXPECT_EQ(r.distance, kInfinity);
  EXPECT_EQ(r.edge_a, 1);
  EXPECT_EQ(r.edge_b, 3);
  EXPECT_EQ(distance(huge, at(-1.2e308, 0), huge, at(1.2e308, 0)).distance, 1.2e308 + (1.2e308 - 1e308));
}

TEST(Distance, InsideAHole) {
  const Polygon frame({rectangle(0, 0, 10, 10), rectangle(2, 2, 8, 8)}), small = square(1);
  const DistanceResult r = distance(frame, at(0, 0), small, at(3, 4));
  EXPECT_EQ(r.distance, 1);
  EXPECT_EQ(r.point_a.x(), 2);
  EXPECT_EQ(r.point_b.x(), 3);
  EXPECT_GE(r.edge_a, 4);
  EXPECT_EQ(distance(small, at(3, 4), frame, at(0, 0)).point_a, r.point_b);
  const Polygon filled({rectangle(0, 0, 10, 10), rectangle(2, 2, 8, 8)}, FillRule::NonZero);
  EXPECT_EQ(distance(filled, at(0, 0), small, at(3, 4)).distance, 0);
}

TEST(Distance, OverlapAndContainmentHaveOneCommonPoint) {
  const Polygon a = square(10), b = square(1);
  const DistanceResult inside = distance(a, at(0, 0), b, at(4, 5));
  EXPECT_EQ(inside.distance, 0);
  EXPECT_EQ(inside.point_a, Vec2(4, 5));
  EXPECT_EQ(inside.point_b, Vec2(4, 5));
  EXPECT_EQ(inside.edge_a, -1);
  EXPECT_EQ(inside.edge_b, 0);
  const DistanceResult turned = distance(b, at(4, 5), a, at(0, 0));
  EXPECT_EQ(turned.edge_a, 0);
  EXPECT_EQ(turned.edge_b, -1);
  const DistanceResult crossing = distance(a, at(0, 0), b, at(9.5, 5));
  EXPECT_EQ(crossing.distance, 0);
  EXPECT_EQ(crossing.point_a, crossing.point_b);
  EXPECT_EQ(crossing.point_a.x(), 10);
  EXPECT_EQ(crossing.edge_a, 1);
  EXPECT_EQ(distance(a, at(0, 0), a, at(0, 0)).distance, 0);
}

TEST(Distance, LimitIsIncluded) {
  const Polygon a = square(1);
  LimitedOptions options;
  options.limit = 5;
  EXPECT_EQ(distance(a, at(0, 0), a, at(4, 5), options).distance, 5);
  options.limit = nudged(5, -1);
  EXPECT_FALSE(distanceWithin(a, at(0, 0), a, at(4, 5), options.limit));
  PairCache cache;
  for (const double limit : {1.0, 5.0, options.limit, 6.0})
    EXPECT_EQ(distanceWithin(a, at(0, 0), a, at(4, 5), limit, cache).has_value(), limit >= 5);
  options.limit = 0;
  EXPECT_EQ(distance(a, at(0, 0), a, at(0.5, 0.5), options).distance, 0);
}

/// What an error allows isn't taken for a distance above the limit, nor is what the last ulps add.
TEST(Distance, LimitMeansTheTruth) {
  const Polygon a({{{0, 2}, {-1, 1}, {2, -2}, {-2, -3}}}), b({{{1, -2}, {0, -3}, {0, 2}}});
  LimitedOptions options;
  options.limit = 3.6;
  const double truth = std::sqrt(12.5);
  for (const double error : {0.0, 0.01, 0.02, 0.1, 1.0}) {
    options.relative_error = error;
    const double found = distance(a, at(0, 0), b, at(-3, 7), options).distance;
    EXPECT_GE(found, truth * (1 - 1e-15)) << error;
    EXPECT_LE(found, 3.6) << error;
    options.absolute_error = 4 * error;
    EXPECT_LE(distance(a, at(0, 0), b, at(-3, 7), options).distance, 3.6) << error;
    options.absolute_error = 0;
  }
  // The true distance is the root of 12.5, which isn't a double: that is found at the double above it, not below it.
  options.relative_error = 0.1;
  for (int steps = -4; steps <= 4; ++steps) {
    options.limit = nudged(truth, steps);
    CollideOptions within;
    within.margin = options.limit;
    const double found = distance(a, at(0, 0), b, at(-3, 7), options).distance;
    if (collide(a, at(0, 0), b, at(-3, 7), within)) {
      EXPECT_LE(found, options.limit) << steps;
    }
    if (steps < -1) {
      EXPECT_EQ(found, kInfinity) << steps;
    }
  }
}

TEST(Distance, RefusesAndNamesTheField) {
  const Polygon a = square(1);
  const auto refused = [&](const LimitedOptions& options) {
    return refusal([&] { distance(a, at(0, 0), a, at(3, 0), options); });
  };
  for (const double bad : {-1.0, kNaN, -kInfinity}) {
    LimitedOptions relative, absolute, limit;
    relative.relative_error = absolute.absolute_error = limit.limit = bad;
    EXPECT_NE(refused(relative).find("tricover: relative_error: "), std::string::npos);
    EXPECT_NE(refused(absolute).find("tricover: absolute_error: "), std::string::npos);
    EXPECT_NE(refused(limit).find("tricover: limit: "), std::string::npos);
  }
  Pose bad = at(0, 0);
  bad.linear() *= 1.001;
  PairCache cache;
  distance(a, at(0, 0), a, at(3, 0), cache);
  EXPECT_NE(refusal([&] { distance(a, bad, a, at(3, 0), cache); }).find("pose_a"), std::string::npos);
  EXPECT_NE(refusal([&] { distance(a, at(3, 0), a, bad, cache); }).find("pose_b"), std::string::npos);
  EXPECT_EQ(distance(a, at(0, 0), a, at(3, 0), cache).distance, 2) << "a refusal changes nothing";
}

const detail::DistanceHint& hintOf(PairCache& cache) { return detail::contentsOf(cache).distance; }

/// A small polygon that jumps through an edge lies as near to the same edges as before, and yet inside.
TEST(DistanceCache, SeesAJumpThroughAnEdge) {
  const Polygon a = square(100), b({scaled(regular(3, 1), 0.01)});
  PairCache cache;
  for (const double x : {-0.04, -0.03, -0.02, -0.015})
    EXPECT_GT(distance(a, at(0, 0), b, at(x, 50), cache).distance, 0);
  EXPECT_EQ(distance(a, at(0, 0), b, at(0.015, 50), cache).distance, 0);
  EXPECT_EQ(distance(a, at(0, 0), b, at(0.02, 50), cache).distance, 0);
  EXPECT_EQ(distance(a, at(0, 0), b, at(-0.02, 50), cache).distance, distance(a, at(0, 0), b, at(-0.02, 50)).distance);
}

/// The hint is of one pair, and of the edges that were nearest or met.
TEST(DistanceCache, KeepsTheHintOfOnePair) {
  const Polygon a({regular(40, 3), regular(5, 1)}), b({regular(30, 1)}), c({regular(30, 1)});
  PairCache cache;
  for (int i = 0; i < 1000; ++i) {
    const Pose pose_b = turnedAndMoved(0.001 * i, 6 * std::cos(0.001 * i), 6 * std::sin(0.001 * i));
    ASSERT_EQ(distance(a, at(0, 0), b, pose_b, cache).distance, distance(a, at(0, 0), b, pose_b).distance);
    EXPECT_FALSE(hintOf(cache).back_off.isOn()) << i;
  }
  EXPECT_NE(hintOf(cache).kind, 0);
  EXPECT_EQ(distance(a, at(0, 0), c, at(10, 0), cache).distance, distance(a, at(0, 0), c, at(10, 0)).distance);
  EXPECT_EQ(hintOf(cache).second_id, c.id());
}

/// A hint that does not help backs off, and is tried again after that.
TEST(DistanceCache, BacksOffWhileHintsDoNotHelp) {
  const Polygon a({scaled(regular(40, 1), 3), regular(5, 1)}), b({regular(30, 1)});
  PairCache cache;
  const auto asks = [&](double angle) {
    const Pose pose_b = turnedAndMoved(angle, 4.1 * std::cos(angle), 4.1 * std::sin(angle));
    EXPECT_EQ(distance(a, at(0, 0), b, pose_b, cache).distance, distance(a, at(0, 0), b, pose_b).distance);
  };
  int rests = 0;
  for (int i = 0; i < 100; ++i) {
    asks(2.4 * i);
    rests += hintOf(cache).back_off.isOn();
  }
  EXPECT_GT(rests, 80) << "jumps";
  for (int i = 0; i < 300; ++i) asks(1e-5 * i);
  EXPECT_FALSE(hintOf(cache).back_off.isOn());
}

/// Sides of a convex polygon may be divided: the edges that are named are the given ones.
TEST(Distance, NamesTheEdgesOfDividedSides) {
  const Ring square = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {1, 2}, {0.25, 2}, {0, 2}, {0, 1}};
  const Polygon wedge({{{-1, 1}, {0, 0}, {0.5, 0.5}, {1, 1}, {0, 1}}});
  const auto nearestEdge = [&](const Ring& ring, const Pose& pose_a, const Pose& pose_b) {
    const Polygon a({ring});
    const DistanceResult found = distance(a, pose_a, wedge, pose_b);
    EXPECT_EQ(found.edge_b == 0 || found.edge_b == 1, true);
    EXPECT_EQ(distance(wedge, pose_b, a, pose_a).edge_b, found.edge_a);
    return found.edge_a;
  };
  const Pose turned = mirrored(turnedAndMoved(1, 3, -2));
  for (const Pose& pose_a : {Pose(Pose::Identity()), turned}) {
    const auto edgeAt = [&](double x) { return nearestEdge(square, pose_a, pose_a * turnedAndMoved(0, x, 2.5)); };
    EXPECT_EQ(edgeAt(1.5), 4);
    EXPECT_EQ(edgeAt(0.5), 6);
    EXPECT_EQ(edgeAt(0.125), 7);
    const auto edgeBack = [&](double x) {
      return nearestEdge(reversed(square), pose_a, pose_a * turnedAndMoved(0, x, 2.5));
    };
    EXPECT_EQ(edgeBack(1.5), 4);
    EXPECT_EQ(edgeBack(0.5), 2);
  }
}

/// As every ring of WKT and GeoJSON is closed.
TEST(Distance, NamesEdgesWithLengthOfAClosedRing) {
  const Polygon l({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 0}}});
  const DistanceResult nearest = distance(l, at(0, 0), l, at(-2, -2.5));
  EXPECT_DOUBLE_EQ(nearest.distance, std::hypot(1, 0.5));
  EXPECT_NE(nearest.edge_a, 6);
  EXPECT_NE(nearest.edge_b, 6);
  EXPECT_EQ(nearest.point_a, Vec2(0, 0));
  const DistanceResult of_point = distance(point({1, 2}), at(0, 0), Polygon({rectangle(3, 1, 4, 3)}), at(0, 0));
  EXPECT_EQ(of_point.distance, 2);
  EXPECT_GE(of_point.edge_a, 0);
  EXPECT_LT(of_point.edge_a, 3);
}

/// So flat that nothing but exact arithmetic tells the edges' distances apart: which ones it is spared changes nothing.
TEST(Distance, OfRingsSqueezedFlatIsThatOfTheirNearestEdges) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Random random(seed);
    const double flat = std::ldexp(1, -47 - 2 * static_cast<int>(seed % 3));
    const auto flatRing = [&] {
      Ring ring;
      for (int i = 0; i < 24; ++i) ring.emplace_back(random.real(-1, 1), flat * random.real(-1, 1));
      return ring;
    };
    const Ring ring_a = flatRing(), ring_b = flatRing();
    const double angle = random.real(0, 3), gap = flat * random.real(2, 2.01);
    const Pose pose_a = turnedAndMoved(angle, 0, 0),
               pose_b = turnedAndMoved(angle, -std::sin(angle) * gap, std::cos(angle) * gap);
    double least = kInfinity;
    for (std::size_t i = 0; i < ring_a.size(); ++i)
      for (std::size_t j = 0; j < ring_b.size(); ++j) {
        const Polygon edge_a = tricover::segment(ring_a[i], ring_a[(i + 1) % ring_a.size()]);
        const Polygon edge_b = tricover::segment(ring_b[j], ring_b[(j + 1) % ring_b.size()]);
        least = std::min(least, distance(edge_a, pose_a, edge_b, pose_b).distance);
      }
    const double found = distance(Polygon({ring_a}), pose_a, Polygon({ring_b}), pose_b).distance;
    EXPECT_NEAR(found, least, 1e-14 * least) << seed;
    EXPECT_GT(found, 0) << seed;
  }
}

}  // namespace
}  // namespace tricover::support
