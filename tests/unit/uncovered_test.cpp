// SPDX-License-Identifier: BSD-3-Clause
// Squares less parallelograms: what is taken away is gone, and nothing else.
#include "contact/uncovered.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "random.h"
#include "test_scale.h"

namespace tricover::detail {
namespace {

using support::Random;
using Corners = std::array<Vec2, 4>;

constexpr double kThin = 1e-9;

Corners box(double low_x, double low_y, double high_x, double high_y) {
  return {Vec2(low_x, low_y), Vec2(high_x, low_y), Vec2(high_x, high_y), Vec2(low_x, high_y)};
}

Corners turnedRound(const Corners& c) { return {c[0], c[3], c[2], c[1]}; }

/// How far inside a parallelogram a point is; negative outside.
double depthIn(const Corners& c, const Vec2& p) {
  double least = 1e9;
  const Vec2 middle = (c[0] + c[2]) / 2;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec2 way = (c[(k + 1) % 4] - c[k]).normalized();
    Vec2 inwards(-way.y(), way.x());
    if (inwards.dot(middle - c[k]) < 0) inwards = -inwards;
    least = std::min(least, inwards.dot(p - c[k]));
  }
  return least;
}

TEST(Uncovered, ByBoxesThatTouchNothingIsLeft) {
  for (const double overlap : {0.0, 0.1 * kThin, 0.1}) {
    Uncovered rest({5, 5}, 1, kThin);
    EXPECT_NEAR(rest.area(), 4, 1e-12);
    rest.takeAway(box(3, 3, 5 + overlap, 9));
    EXPECT_NEAR(rest.area(), 2 - 2 * overlap, 3 * kThin);
    EXPECT_GT(rest.point().x(), 5);
    rest.takeAway(turnedRound(box(5, 5, 9, 9)));
    EXPECT_NEAR(rest.area(), 1 - overlap, 4 * kThin);
    EXPECT_LT(rest.point().y(), 5);
    rest.takeAway(box(4.5, 0, 6, 5));
    EXPECT_TRUE(rest.isEmpty());
    EXPECT_EQ(rest.area(), 0);
  }
}

TEST(Uncovered, ASlitIsLeftUnlessItIsThin) {
  for (const double width : {0.5 * kThin, 1.5 * kThin, 8 * kThin}) {
    Uncovered rest({0, 0}, 1, kThin);
    rest.takeAway(box(-2, -2, 0, 2));
    rest.takeAway(box(width, -2, 2, 2));
    EXPECT_EQ(rest.isEmpty(), width < 2 * kThin);
    if (!rest.isEmpty()) {
      EXPECT_NEAR(rest.point().x(), width / 2, kThin);
    }
  }
}

TEST(Uncovered, ALineTakesNothing) {
  Uncovered rest({0, 0}, 1, kThin);
  rest.takeAway({Vec2(-3, -3), Vec2(3, 3), Vec2(4, 4), Vec2(-2, -2)});
  EXPECT_EQ(rest.area(), 4);
}

/// Its area is that of a thousand points, and its own point is in none.
TEST(Uncovered, ByParallelogramsTheRestIsWhatNoneHolds) {
  int emptied = 0, left = 0;
  for (int i = 0; i < support::scaledCount(100); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const auto any = [&](double reach) { return Vec2(random.real(-reach, reach), random.real(-reach, reach)); };
    Uncovered rest(Vec2::Zero(), 1, kThin);
    std::vector<Corners> taken;
    for (int k = random.integer(1, 16); k > 0 && !rest.isEmpty(); --k) {
      const Vec2 u = any(3), w = any(3), v = random.oneIn(4) ? any(1) : Vec2(rest.point() - (u + w) / 2);
      taken.push_back({v, v + u, v + u + w, v + w});
      const double before = rest.area();
      rest.takeAway(taken.back());
      ASSERT_LE(rest.area(), before + 1e-12) << i;
      if (rest.isEmpty()) break;
      for (const Corners& corners : taken) ASSERT_LE(depthIn(corners, rest.point()), kThin) << i;
      ASSERT_LE(rest.point().lpNorm<Eigen::Infinity>(), 1) << i;
    }
    (rest.isEmpty() ? emptied : left) += 1;
    int outside = 0;
    for (int k = 0; k < 1000; ++k) {
      const Vec2 p = any(1);
      bool held = false;
      for (const Corners& corners : taken) held = held || depthIn(corners, p) > -kThin;
      outside += !held;
    }
    EXPECT_NEAR(rest.area(), 4 * outside / 1000.0, 0.3) << i;
    if (rest.isEmpty()) {
      EXPECT_EQ(outside, 0) << i;
    }
  }
  if (emptied + left >= 100) {
    EXPECT_GE(emptied, 10);
    EXPECT_GE(left, 10);
  }
}

}  // namespace
}  // namespace tricover::detail
