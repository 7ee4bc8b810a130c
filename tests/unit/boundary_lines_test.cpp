// SPDX-License-Identifier: BSD-3-Clause
// The search of penetrations from within: the lines that it gathers, and what it knows when it ends early.
#include "penetration/boundary_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "numbers/angle.h"
#include "numbers/rounding.h"
#include "penetration/penetration.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/collide.h"

namespace tricover::detail {
namespace {

/// Found by `soak cache --seed 77`, a map case: a tiny polygon deep behind a long edge. The lower bound was above the
/// depth, because the nearest point of the edge's line was not offered in any cell.
TEST(BoundaryLines, TheNearestPointOfALongSegmentIsOfferedByAShortPiece) {
  support::Random random(1);
  const int cases = support::scaledCount(2000);
  for (int i = 0; i < cases; ++i) {
    const Vec2 axis = support::direction(random.real(0, 7)), normal(-axis.y(), axis.x());
    const double away = std::pow(10, random.real(0, 6)), length = std::pow(10, random.real(0, 6));
    const Vec2 foot = away * normal;
    const double noise = 2 * kUnitRoundoff * (away + 2 * length);
    BoundaryLines lines(noise, 16 * noise);
    lines.clear(1);
    const Ends segment{foot - length * axis, foot + random.real(0.5, 1) * length * axis};
    ASSERT_TRUE(lines.add({segment, true, noise}, foot + Vec2(random.real(-0.5, 0.5), random.real(-0.5, 0.5)), 1));
    int offered = 0;
    lines.forEachPossibleLimit([&](const Vec2& p, double) {
      ++offered;
      EXPECT_LE((p - foot).norm(), 16 * noise * (1 + away / length));  // its ends tell the axis
    });
    EXPECT_EQ(offered, 1) << "case " << i << ", away " << away << ", length " << length;
  }
}

/// Between the x axis and the diagonal: half of the way to what is in that sector, or comes into it, but not to what is
/// beside it.
TEST(BoundaryLines, OnlyLinesInASectorLeaveLessRoom) {
  const Ends axis{{0, 0}, {10, 0}}, diagonal{{0, 0}, {10, 10}}, beside{{1, -1}, {3, -0.5}}, inside{{4, 1}, {4, 2}},
      through{{2, -1}, {2, 1}};
  const auto room = [&](const std::vector<Ends>& others) {
    BoundaryLines lines(1e-15, 16e-15);
    lines.clear(8);
    for (const Ends& line : {axis, diagonal}) EXPECT_TRUE(lines.add({line, true, 1e-15}, Vec2::Zero(), 100));
    std::vector<BoundaryLines::LeavingLine> rays;
    lines.addRays(Vec2::Zero(), rays);
    EXPECT_EQ(rays.size(), 2u);
    for (const Ends& line : others) EXPECT_TRUE(lines.add({line, true, 1e-15}, Vec2::Zero(), 100));
    return lines.roomBetween(Vec2::Zero(), rays[0], rays[1], kPi / 4, 3);
  };
  EXPECT_EQ(room({}), 3);
  EXPECT_EQ(room({beside}), 3);
  EXPECT_NEAR(room({beside, inside}), std::hypot(4, 1) / 2, 1e-12);
  EXPECT_NEAR(room({beside, inside, through}), 1, 1e-12);
}

/// What the cells that are left bound, with a margin and without.
TEST(PenetrationSearch, ThatEndsEarlyKeepsItsLowerBoundTrue) {
  support::Random random(2);
  const int cases = support::scaledCount(300);
  int unfinished = 0, longer = 0;
  for (int i = 0; i < cases; ++i) {
    const Polygon a({support::star(random, 24, 0.4, 1)}), b({support::star(random, 16, 0.3, 0.8)});
    const Pose pose_a = support::turnedAndMoved(random.real(0, 7), 0, 0);
    const Pose pose_b = support::turnedAndMoved(random.real(0, 7), random.real(-0.5, 0.5), random.real(-0.5, 0.5));
    if (!collide(a, pose_a, b, pose_b)) continue;
    for (const double margin : {0.0, 0.05}) {
      const Penetration whole = penetrationInOrder(detail::dataOf(a), pose_a, detail::dataOf(b), pose_b, margin);
      for (const std::size_t most : {1u, 4u, 16u, 64u}) {
        const Penetration cut = penetrationInOrder(detail::dataOf(a), pose_a, detail::dataOf(b), pose_b, margin, most);
        EXPECT_LE(cut.lower_bound, whole.depth + 1e-12) << "case " << i << ", margin " << margin << ", most " << most;
        EXPECT_GE(cut.depth, whole.lower_bound - 1e-12) << "case " << i << ", margin " << margin << ", most " << most;
        unfinished += cut.lower_bound < cut.depth - 1e-9;
        longer += cut.depth > whole.depth + 1e-9;
      }
    }
  }
  EXPECT_GT(unfinished, cases);
  EXPECT_GT(longer, cases / 2);
}

}  // namespace
}  // namespace tricover::detail
