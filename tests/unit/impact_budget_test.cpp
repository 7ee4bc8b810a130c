// SPDX-License-Identifier: BSD-3-Clause
// Times of impact and conflicts whose search ends at its budget say what is proven, and that they do.
#include <gtest/gtest.h>

#include <vector>

#include "shapes.h"
#include "tricover/conflicts.h"
#include "tricover/segment.h"
#include "tricover/time_of_impact.h"

namespace tricover::support {
namespace {

const Polygon kSquare({rectangle(-1, -1, 1, 1)});
const Motion kStill;

/// Triangles side by side that share an apex at the origin, to the left or to the right of it.
Polygon fan(int triangles, double side) {
  Ring ring;
  for (int i = 0; i < triangles; ++i) {
    const double low = -1 + 2.0 * i / triangles, high = low + 1.0 / triangles;
    ring.push_back({0, 0});
    ring.push_back({side, side > 0 ? low : high});
    ring.push_back({side, side > 0 ? high : low});
  }
  return Polygon({ring});
}

/// The apexes pass by each other while one fan turns: a million pairs of edges are a hair apart, all the time.
TEST(ImpactBudget, EndsWithTheProvenTime) {
  const Polygon left = fan(400, -1), right = fan(400, 1);
  Motion up = Motion::translation(turnedAndMoved(0, 1e-9, -1e-4), {0, 1e-3});
  up.angle = 0.1;
  const auto impact = timeOfImpact(left, kStill, right, up);
  ASSERT_TRUE(impact.has_value());
  EXPECT_TRUE(impact->budget_ended);
  EXPECT_GT(impact->time, 0);
  EXPECT_LE(impact->time, 1);
  EXPECT_GE(impact->edge_a, 0);
  EXPECT_LT(impact->edge_a, left.edgeCount());
  EXPECT_LT(impact->edge_b, right.edgeCount());
  EXPECT_NEAR(impact->normal.norm(), 1, 1e-9);
  const auto all = conflicts(left, kStill, right, up);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_TRUE(all[0].budget_ended && all[0].impact.budget_ended);
  EXPECT_EQ(all[0].end, 1);
  // Fewer edges are not too many.
  EXPECT_FALSE(timeOfImpact(fan(20, -1), kStill, fan(20, 1), up).has_value());
}

/// A square slides along the straight side of a polygon, convex or not, exactly as deep as is allowed: the deepest
/// points of both ends of a step tell that the contact lasts.
TEST(ImpactBudget, LastsWhereAnOverlapStaysExactlyAsDeepAsIsAllowed) {
  const Polygon notched(Ring{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-0.5, 0}});
  const Motion beside = Motion::translation(turnedAndMoved(0, 1.875, -0.5), {0, 1});
  for (const Polygon& a : {notched, kSquare}) {
    EXPECT_FALSE(timeOfImpact(a, kStill, kSquare, beside, {-0.125, 0, true}).has_value());
    const std::vector<Conflict> all = conflicts(a, kStill, kSquare, beside, {-0.125, 0});
    ASSERT_EQ(all.size(), 1u);
    EXPECT_FALSE(all[0].budget_ended || all[0].impact.budget_ended);
    EXPECT_EQ(all[0].impact.time, 0);
    EXPECT_EQ(all[0].end, 1);
  }
}

/// A box leaves the hole that it fills: it stays in what is around it, however far it goes. And one of a size that is
/// nothing beside its way slides along a wall.
TEST(ImpactBudget, LastsForExtremeRatios) {
  const Polygon hole = box(1, 1).complement();
  for (const double far : {1e60, 1e100, 1e150, 1e300}) {
    const std::vector<Conflict> all =
        conflicts(hole, kStill, box(1, 1), Motion::translation(turnedAndMoved(0, 0, 0), {0, far}));
    ASSERT_EQ(all.size(), 1u) << far;
    EXPECT_EQ(all[0].impact.time, 0);
    EXPECT_EQ(all[0].end, 1);
    EXPECT_FALSE(all[0].budget_ended) << far;
  }
  for (const double size : {1e-30, 1e-70, 1e-150, 1e-300}) {
    const Polygon speck({{{0, 0}, {size, 0}, {size, size}, {0, size}}});
    const auto all = conflicts(kSquare, kStill, speck, Motion::translation(turnedAndMoved(0, -2, 1), {8, 0}));
    ASSERT_EQ(all.size(), 1u) << size;
    EXPECT_NEAR(all[0].end, 0.375, 1e-6);
    EXPECT_FALSE(all[0].budget_ended) << size;
  }
}

/// They touch at the start within rounding alone or not at all, and are never as deep as is allowed.
TEST(ImpactBudget, LeavesOutAContactThatIsNoImpact) {
  const Polygon notched(Ring{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-0.5, 0}});
  int without = 0;
  for (double off = 1e-13; off < 1e-10; off *= 1.5) {
    const Motion beside = Motion::translation(turnedAndMoved(0, 1.875 + off, -0.5), {0, 1});
    const ImpactOptions options{-0.125, 0, true};
    if (timeOfImpact(notched, kStill, kSquare, beside, {-0.125, 0})) continue;
    ++without;
    EXPECT_FALSE(timeOfImpact(notched, kStill, kSquare, beside, options)) << off;
    EXPECT_TRUE(conflicts(notched, kStill, kSquare, beside, options).empty()) << off;
  }
  EXPECT_GE(without, 2);
}

}  // namespace
}  // namespace tricover::support
