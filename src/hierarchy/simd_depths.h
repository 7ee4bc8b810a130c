// SPDX-License-Identifier: BSD-3-Clause
// How deep points are in a region, a guess. See simd_gaps.h for Lanes.
#pragma once

#include "hierarchy/inner_discs.h"
#include "hierarchy/simd_gaps.h"
#include "numbers/beside_segment.h"

namespace tricover::detail::simd {

template <class Lanes>
void measureDepths(const ThinnedOutline& outline, DepthProbes& probes) {
  const Lanes at_x = Lanes::load(probes.x), at_y = Lanes::load(probes.y), zero = Lanes::all(0);
  Lanes square = Lanes::all(1e30f);
  unsigned odd = 0;
  int winding[kLanes] = {};
  for (const ThinnedOutline::Edge *e = outline.edges.data(), *end = e + outline.edges.size(); e != end; ++e) {
    const Lanes x = at_x - e->x, y = at_y - e->y;
    square = smaller(square, besideSegment(x, y, e->along_x, e->along_y, e->inverse_square).square);
    const unsigned above_start = above(y, zero), above_end = above(at_y, Lanes::all(e->end_y));
    const unsigned crossed = (above_start ^ above_end) & above(y * e->slope, x);
    odd ^= crossed;
    if (outline.is_even_odd) continue;
    for (unsigned left = crossed; left != 0; left &= left - 1) {
      const int i = __builtin_ctz(left);
      winding[i] += (above_start >> i & 1) != 0 ? 1 : -1;
    }
  }
  root(square).store(probes.depth);
  for (int i = 0; i < kLanes; ++i)
    if (outline.is_even_odd ? (odd >> i & 1) == 0 : winding[i] == 0) probes.depth[i] = -probes.depth[i];
}

}  // namespace tricover::detail::simd
