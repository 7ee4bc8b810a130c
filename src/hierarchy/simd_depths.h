// SPDX-License-Identifier: BSD-3-Clause
// How deep points are in a region, a guess. See simd_gaps.h for Lanes.
#pragma once

#include "hierarchy/inner_discs.h"
#include "hierarchy/simd_gaps.h"
#include "numbers/beside_segment.h"

namespace tricover::detail::simd {

/// A number below 8 for each lane, bit by bit: what it counts is counted modulo 8.
struct LaneCounts {
  unsigned ones = 0, twos = 0, fours = 0;

  [[gnu::always_inline]] void add(unsigned lanes) {
    const unsigned carry = ones & lanes;
    ones ^= lanes;
    fours ^= twos & carry;
    twos ^= carry;
  }
};

template <class Lanes>
void measureDepths(const ThinnedOutline& outline, DepthProbes& probes) {
  const Lanes at_x = Lanes::load(probes.x), at_y = Lanes::load(probes.y), zero = Lanes::all(0);
  Lanes square = Lanes::all(1e30f);
  const bool is_even_odd = outline.isEvenOdd();
  unsigned odd = 0;
  LaneCounts ups, downs;
  for (const ThinnedOutline::Edge& e : outline) {
    const Lanes x = at_x - e.x, y = at_y - e.y;
    square = smaller(square, besideSegment(x, y, e.along_x, e.along_y, e.inverse_square).square);
    const unsigned above_start = above(y, zero), above_end = above(at_y, Lanes::all(e.end_y));
    const unsigned crossed = (above_start ^ above_end) & above(y * e.slope, x);
    odd ^= crossed;
    if (is_even_odd) continue;
    ups.add(crossed & above_start);
    downs.add(crossed & ~above_start);
  }
  const unsigned inside = is_even_odd ? odd : odd | (ups.twos ^ downs.twos) | (ups.fours ^ downs.fours);
  root(square).store(probes.depth);
  for (int i = 0; i < kLanes; ++i)
    if ((inside >> i & 1) == 0) probes.depth[i] = -probes.depth[i];
}

}  // namespace tricover::detail::simd
