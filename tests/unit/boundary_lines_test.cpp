// SPDX-License-Identifier: BSD-3-Clause
#include "penetration/boundary_lines.h"

#include <gtest/gtest.h>

#include <cmath>

#include "numbers/rounding.h"
#include "shapes.h"
#include "test_scale.h"

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

}  // namespace
}  // namespace tricover::detail
