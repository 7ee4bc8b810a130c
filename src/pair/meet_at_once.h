// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "hierarchy/simd.h"
#include "numbers/float4.h"
#include "pair/collide_by_hierarchy.h"

namespace tricover::detail {

/// A lower bound, in a's units, of the gap between the boxes around everything, by separating axes; not positive where
/// they may meet. No point of a is farther than 1 from its origin, and none of b from its own, because b's unit is at
/// most a's: so 4 is more than all extents together. Floats round as kGapRounding counts; far away they would overflow,
/// and the error may be as large as the way.
inline double rootGap(const Box& a, const Box& b, const UnitMap& map, double rounding) {
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
  return std::max(larger_gaps[0], larger_gaps[1]) - rounding * (far[0] + far[1] + 4) - map.error;
}

/// What boxes around everything, few edges and inner discs tell, before the trees are searched. Lengths are in a's
/// units: `limit` is that of gaps that matter, `clearance` is that of the answer.
inline Meeting meetAtOnce(const Hierarchy& a, const Hierarchy& b, const UnitMap& map, double rounding, double limit,
                          Wanted wanted, const EdgeCheck& check, double& clearance) {
  // Nothing of the regions is outside of the boxes around everything, so that no containment is left to ask for.
  const double gap = rootGap(a.root, b.root, map, rounding);
  if (gap > limit) {
    clearance = gap;
    return Meeting::Apart;
  }
  const bool near = std::abs(map.tx) + std::abs(map.ty) < 4;  // false for NaN
  if (!near || wanted == Wanted::Edges) return Meeting::Unknown;
  if (wanted == Wanted::Answer && limit == 0 && a.small && b.small)
    return smallMeet(*a.small, *b.small, map, rounding, check);
  // Inner discs hardly meet unless the boxes are deep in each other.
  const double deep = 0.7 * std::min<double>(a.root.across, b.root.across * map.scale);
  if (!(gap < -deep)) return Meeting::Unknown;
  const double depth = innerDepth(a.inner_discs, b.inner_discs, map, rounding);
  if (!(depth > 0)) return Meeting::Unknown;
  clearance = depth;
  return Meeting::Meet;
}

}  // namespace tricover::detail
