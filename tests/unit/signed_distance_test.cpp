// SPDX-License-Identifier: BSD-3-Clause
// Signed distances known by hand, and what moving along the normal does. tests/laws/distance.cpp has the
// laws of all families.
#include "tricover/signed_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "random.h"
#include "refusal.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/distance.h"
#include "tricover/segment.h"

namespace tricover::support {
namespace {

double signedAt(const Polygon& a, const Polygon& b, const Vec2& at, double margin = 0) {
  DistanceOptions options;
  options.margin = margin;
  return signedDistance(a, Pose::Identity(), b, tricover::pose(at.x(), at.y()), options).distance;
}

TEST(SignedDistance, OfBoxesThatAreApartTouchAndOverlap) {
  const Polygon square = box(4, 4);
  EXPECT_EQ(signedAt(square, square, {5, 1}), 1);
  EXPECT_EQ(signedAt(square, square, {7, 8}), 5);
  EXPECT_EQ(signedAt(square, square, {4, 1}), 0);
  EXPECT_EQ(signedAt(square, square, {4, 4}), 0);
  EXPECT_NEAR(signedAt(square, square, {3.5, 1}), -0.5, 1e-14);
  EXPECT_NEAR(signedAt(square, square, {0, 0}), -2, 1e-14);
  const SignedDistance touch = signedDistance(square, tricover::pose(0, 0), square, tricover::pose(4, 1));
  EXPECT_NEAR(touch.normal.x(), 1, 1e-12);
  EXPECT_EQ(touch.edge_a, 1);
  EXPECT_EQ(touch.edge_b, 3);
}

TEST(SignedDistance, MarginsAreSubtractedFromEither) {
  const Polygon square = box(4, 4);
  EXPECT_EQ(signedAt(square, square, {7, 8}, 1), 4);
  EXPECT_EQ(signedAt(square, square, {7, 8}, 5), 0);
  EXPECT_EQ(signedAt(square, square, {7, 8}, 6), -1);
  EXPECT_EQ(signedAt(square, square, {4, 1}, 0.5), -0.5);
  EXPECT_NEAR(signedAt(square, square, {3.5, 1}, 0.25), -0.75, 1e-14);
  // A disc in a box, a rounding beside its margin.
  EXPECT_EQ(signedAt(square, point({0, 0}), {3, 0}, 1), 0);
  EXPECT_GT(signedAt(square, point({0, 0}), {nudged(3, 1), 0}, 1), 0);
  EXPECT_LT(signedAt(square, point({0, 0}), {nudged(3, -1), 0}, 1), 0);
}

TEST(SignedDistance, OfDegeneratePolygons) {
  const Polygon plate = box(2, 4), dot = point({0, 0}), rod = segment({0, -1}, {0, 1});
  EXPECT_NEAR(signedAt(plate, dot, {0.75, 0}), -0.25, 1e-14);
  EXPECT_NEAR(signedDistance(plate, tricover::pose(0, 0), dot, tricover::pose(0.75, 0)).normal.x(), 1, 1e-12);
  EXPECT_EQ(signedAt(plate, dot, {1, 0}), 0);
  EXPECT_EQ(signedAt(plate, rod, {3, 1}), 2);
  EXPECT_NEAR(signedAt(plate, rod, {0.5, 0}), -0.5, 1e-14);
  EXPECT_EQ(signedAt(dot, dot, {0, 0}), 0);
  EXPECT_EQ(signedAt(rod, rod, {0, 0.5}), 0);
  EXPECT_EQ(signedAt(rod, dot, {3, 5}), 5);
}

TEST(SignedDistance, OfRegionsThatAreNotConvex) {
  const Polygon frame({rectangle(-5, -5, 5, 5), rectangle(-3, -3, 3, 3)});
  EXPECT_EQ(signedAt(frame, box(2, 2), {0, 0}), 2);
  EXPECT_EQ(signedAt(frame, box(2, 2), {2, 0}), 0);
  EXPECT_NEAR(signedAt(frame, box(2, 2), {2.5, 0}), -0.5, 1e-11);
  // A peg that fits its slot exactly is nowhere deep, and into both walls of its corner it is by the diagonal.
  const Polygon slot({{{-3, -3}, {3, -3}, {3, 3}, {1, 3}, {1, 0}, {-1, 0}, {-1, 3}, {-3, 3}}});
  EXPECT_EQ(signedAt(slot, box(2, 2), {0, 1.5}), 0);
  EXPECT_EQ(signedAt(slot, box(2, 2), {0, 1}), 0);
  EXPECT_NEAR(signedAt(slot, box(2, 2), {0.25, 0.75}), -0.25 * std::sqrt(2), 1e-14);
  EXPECT_GT(signedAt(slot, box(1.75, 1.75), {0, 1.5}), 0.1);
}

TEST(SignedDistance, OfAnySize) {
  for (const double size : {1e-300, 1e-150, 1e-10, 1e10, 1e150, 1e290}) {
    const Polygon square = box(4, 4).scaled(size);
    EXPECT_NEAR(signedAt(square, square, Vec2(7, 8) * size) / size, 5, 1e-13) << size;
    EXPECT_NEAR(signedAt(square, square, Vec2(3.5, 1) * size) / size, -0.5, 1e-13) << size;
    EXPECT_NEAR(signedAt(square, square, Vec2(3.5, 1) * size, size) / size, -1.5, 1e-13) << size;
  }
}

/// A vertex is beside an edge's end or, by less than doubles tell, beside its inner.
TEST(SignedDistance, NormalLeadsFromPointToPoint) {
  Random random(3);
  const int cases = scaledCount(20000);
  int ends = 0;
  for (int i = 0; i < cases; ++i) {
    const double size = std::pow(10, random.real(-12, 0)),
                 past = random.coin() ? 0 : std::pow(10, random.real(-10, -7));
    const Polygon b = segment({0, 0}, {1, 0}), a(Ring{{0, 0}, {-size, -size}, {size, -0.7 * size}});
    Pose pose_b = support::turnedAndMoved(random.real(0, 6), random.real(-1, 1), random.real(-1, 1)), pose_a = pose_b;
    pose_a.translation() = pose_b * Vec2(past, -random.real(0.1, 1));
    const SignedDistance s = signedDistance(a, pose_a, b, pose_b);
    ends += s.point_b == pose_b.translation();
    ASSERT_LE((s.point_b - s.point_a - s.distance * s.normal).norm(), 1e-14) << i;
  }
  EXPECT_GT(ends, cases / 10);
  EXPECT_LT(ends, cases / 10 * 9);
}

TEST(SignedDistance, OfPointsFarFromEachOther) {
  for (int exponent = -1000; exponent <= 1000; exponent += 4) {
    const double far = std::ldexp(1, exponent);
    const SignedDistance s = signedDistance(point({-far, far}), Pose::Identity(), point({0, 0}), Pose::Identity());
    EXPECT_NEAR(s.normal.x(), std::sqrt(0.5), 1e-15) << exponent;
    EXPECT_NEAR(s.normal.y(), -std::sqrt(0.5), 1e-15) << exponent;
    EXPECT_NEAR(s.distance / far, std::sqrt(2), 1e-15) << exponent;
  }
}

/// Of convex polygons that are apart, by no less than they are moved by; of others by no more than that, either way.
TEST(SignedDistance, MovingAlongTheNormalIncreasesIt) {
  const int cases = scaledCount(3000);
  int apart = 0, shallower = 0;
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Polygon a({anyConvex(random, 1)}), b({anyConvex(random, random.real(0.1, 2))});
    const Pose pose_a = randomPose(random, 1);
    Pose pose_b = randomPose(random, 2);
    const SignedDistance before = signedDistance(a, pose_a, b, pose_b);
    const double by = random.real(0, 2) * (before.distance < 0 ? 1e-3 : 1);
    pose_b.translation() += by * before.normal;
    const double after = signedDistance(a, pose_a, b, pose_b).distance;
    apart += before.distance > 0;
    shallower += before.distance < 0 && after > before.distance;
    ASSERT_GE(after, before.distance + (before.distance < 0 ? -by : by) - 1e-13) << i << ", " << before.distance;
    if (before.distance < 0) {
      ASSERT_LE(after, before.distance + by + 1e-13) << i;
    }
  }
  EXPECT_GT(apart, cases / 5);
  EXPECT_LT(apart, 4 * cases / 5 + 1);
  EXPECT_GT(2 * shallower, cases - apart);
}

TEST(SignedDistance, OfComplements) {
  const Polygon lot = box(20, 10).complement(), car = box(2, 1);
  const auto at = [&](double x, double y) {
    return signedDistance(lot, Pose::Identity(), car, tricover::pose(x, y)).distance;
  };
  EXPECT_EQ(at(0, 0), 4.5);
  EXPECT_EQ(at(0, 4.5), 0);
  EXPECT_EQ(at(3, 4.75), -0.25);
  EXPECT_NEAR(at(9.25, 4.75), -0.25 * std::sqrt(2), 1e-14);
  EXPECT_EQ(signedDistance(lot, Pose::Identity(), lot, Pose::Identity()).distance,
            -std::numeric_limits<double>::infinity());
}

/// Also where the distance, rounded, is more.
TEST(SignedDistance, IsPositiveOnlyBeyondTheMargin) {
  const int cases = scaledCount(3000);
  int within = 0;
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Polygon a({anyConvex(random, 1)}), b({anyConvex(random, 1)});
    const Pose pose_a = randomPose(random, 9), pose_b = randomPose(random, 9);
    DistanceOptions options;
    options.margin = nudged(distance(a, pose_a, b, pose_b).distance, -1);
    if (!(options.margin > 0)) continue;
    const bool is_within = collide(a, pose_a, b, pose_b, {options.margin});
    within += is_within;
    ASSERT_EQ(signedDistance(a, pose_a, b, pose_b, options).distance <= 0, is_within) << i;
  }
  EXPECT_GT(within, cases / 50);
  EXPECT_LT(within, cases / 2);
}

TEST(SignedDistance, AllowsErrors) {
  const Polygon disc({regular(500, 1)}), hole({regular(500, 4), regular(500, 3)});
  const double exact = signedAt(disc, hole, {0.25, 0.125});
  DistanceOptions options;
  options.relative_error = 0.1;
  const double near = signedDistance(disc, tricover::pose(0, 0), hole, tricover::pose(0.25, 0.125), options).distance;
  EXPECT_GE(near, exact * (1 - 1e-14));
  EXPECT_LE(near, exact * 1.1);
}

TEST(SignedDistance, RefusesWhatDistanceRefuses) {
  const Polygon square = box(1, 1);
  Pose skewed = Pose::Identity();
  skewed.linear()(0, 0) = 2;
  const auto refused = [&](const Pose& pose, const DistanceOptions& options) {
    return refusal([&] { signedDistance(square, Pose::Identity(), square, pose, options); });
  };
  DistanceOptions options;
  EXPECT_NE(refused(skewed, options).find("pose_b"), std::string::npos);
  options.margin = std::numeric_limits<double>::infinity();
  EXPECT_NE(refused(Pose::Identity(), options).find("margin"), std::string::npos);
  options.margin = std::nan("");
  EXPECT_NE(refused(Pose::Identity(), options).find("margin"), std::string::npos);
  options.margin = 0;
  options.relative_error = -1;
  EXPECT_NE(refused(Pose::Identity(), options).find("relative_error"), std::string::npos);
}

}  // namespace
}  // namespace tricover::support
