// SPDX-License-Identifier: BSD-3-Clause
// What the boxes around everything tell.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "hierarchy/simd.h"
#include "numbers/double2.h"
#include "numbers/float4.h"

namespace tricover::detail {

/// A lower bound, in a's units, of the gap between the boxes around everything, by separating axes; not positive where
/// they may meet. No point of a is farther than 1 from its origin, and none of b from its own, because b's unit is at
/// most a's: so 4 is more than all extents together. Floats round as kGapRounding counts; far away they would overflow,
/// and the error may be as large as the way.
inline double rootGap(const Box& a, const Box& b, const UnitMap& map) {
  assert(map.scale <= 1);
  const Double2 m0{map.r00, map.r10}, m1{map.r01, map.r11}, center_b = widened(load2(&b.x));
  const Double2 turned = widened(load2(&b.ux)), axis_b = m0 * turned[0] + m1 * turned[1];
  const Double2 way =
      (m0 * center_b[0] + m1 * center_b[1]) * map.scale + Double2{map.tx, map.ty} - widened(load2(&a.x));
  const Double2 far = absolute(way);
  if (!(far[0] + far[1] < 1e30)) return -std::numeric_limits<double>::infinity();
  // Lanes: along and across a, along and across b. For an axis v, across is the way's v_x y - v_y x.
  const Float4 axes = joined(load2(&a.ux), narrowed(axis_b)),
               across = shuffled<1, 0, 3, 2>(axes) * Float4{1, -1, 1, -1};
  const Float4 center = joined(narrowed(way), Float2{});
  const Float4 apart = absolute(shuffled<0, 0, 0, 0>(center) * axes + shuffled<1, 1, 1, 1>(center) * across);
  const Float4 products = axes * shuffled<2, 3, 0, 1>(axes), crossed = axes * shuffled<3, 2, 1, 0>(axes);
  const Float4 cosine = absolute(products + shuffled<1, 0, 3, 2>(products));
  const Float4 sine = absolute(crossed - shuffled<1, 0, 3, 2>(crossed));
  const Float4 extents = joined(load2(&a.along), load2(&b.along) * static_cast<float>(map.scale));
  const Float4 gaps = apart - (extents + shuffled<2, 3, 0, 1>(extents) * cosine + shuffled<3, 2, 1, 0>(extents) * sine);
  const Float4 larger_gaps = larger(gaps, shuffled<2, 3, 0, 1>(gaps));
  return std::max(larger_gaps[0], larger_gaps[1]) - map.rounding * (far[0] + far[1] + 4) - map.error;
}

/// A lower bound, in units, of the distance of a place from the box around everything; not positive where it may be
/// inside. The box's axis is of unit length as far as floats are: kGapRounding is far more than doubles add to that.
inline double distanceFromRoot(const Box& root, const Place& place) {
  const double dx = place.x - root.x, dy = place.y - root.y;
  const double along = std::max(std::abs(dx * root.ux + dy * root.uy) - root.along, 0.0);
  const double across = std::max(std::abs(dy * root.ux - dx * root.uy) - root.across, 0.0);
  const double squares = along * along + across * across;
  const double apart = squares < 1e300 ? std::sqrt(squares) : std::max(along, across);  // squares may overflow
  return apart - (std::abs(dx) + std::abs(dy) + 4) * kGapRounding - place.error;
}

}  // namespace tricover::detail
