// SPDX-License-Identifier: BSD-3-Clause
// Signed distances known by hand. tests/laws/distance.cpp has the laws.
#include "tricover/signed_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "refusal.h"
#include "shapes.h"
#include "tricover/distance.h"
#include "tricover/segment.h"

namespace tricover::support {
namespace {

double signedAt(const Polygon& a, const Polygon& b, const Vec2& at, double margin = 0) {
  DistanceOptions options;
  options.margin = margin;
  return signedDistance(a, Pose::Identity(), b, tricover::pose(at.x(), at.y()), options).distance;
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
  const Polygon square = box(4, 4), plate = box(2, 4), dot = point({0, 0}), rod = segment({0, -1}, {0, 1});
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
  const SignedDistance touch = signedDistance(square, tricover::pose(0, 0), square, tricover::pose(4, 1));
  EXPECT_NEAR(touch.normal.x(), 1, 1e-12);
  EXPECT_EQ(touch.edge_a, 1);
  EXPECT_EQ(touch.edge_b, 3);
  EXPECT_NEAR(signedDistance(plate, tricover::pose(0, 0), dot, tricover::pose(0.75, 0)).normal.x(), 1, 1e-12);
}

TEST(SignedDistance, OfRegionsThatAreNotConvex) {
  const Polygon frame({rectangle(-5, -5, 5, 5), rectangle(-3, -3, 3, 3)});
  const Polygon slot({{{-3, -3}, {3, -3}, {3, 3}, {1, 3}, {1, 0}, {-1, 0}, {-1, 3}, {-3, 3}}});
  expectDistances({
      {frame, box(2, 2), {0, 0}, 0, 2},
      {frame, box(2, 2), {2, 0}, 0, 0},
      {frame, box(2, 2), {2.5, 0}, 0, -0.5, 1e-11},
      // A peg that fits its slot exactly is nowhere deep, and into both walls of its corner it is by the diagonal.
      {slot, box(2, 2), {0, 1.5}, 0, 0},
      {slot, box(2, 2), {0, 1}, 0, 0},
      {slot, box(2, 2), {0.25, 0.75}, 0, -0.25 * std::sqrt(2), 1e-14},
  });
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

TEST(SignedDistance, OfPointsFarFromEachOther) {
  for (int exponent = -1000; exponent <= 1000; exponent += 4) {
    const double far = std::ldexp(1, exponent);
    const SignedDistance s = signedDistance(point({-far, far}), Pose::Identity(), point({0, 0}), Pose::Identity());
    EXPECT_NEAR(s.normal.x(), std::sqrt(0.5), 1e-15) << exponent;
    EXPECT_NEAR(s.normal.y(), -std::sqrt(0.5), 1e-15) << exponent;
    EXPECT_NEAR(s.distance / far, std::sqrt(2), 1e-15) << exponent;
  }
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
  const auto expectNamed = [&](const char* name, const Pose& pose, const DistanceOptions& options) {
    const std::string text = refusal([&] { signedDistance(square, Pose::Identity(), square, pose, options); });
    EXPECT_NE(text.find(name), std::string::npos) << text;
  };
  expectNamed("pose_b", skewed, {});
  for (const double margin : {HUGE_VAL, std::nan("")}) expectNamed("margin", Pose::Identity(), {margin});
  expectNamed("relative_error", Pose::Identity(), {0, -1});
}

}  // namespace
}  // namespace tricover::support
