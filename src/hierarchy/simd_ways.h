// SPDX-License-Identifier: BSD-3-Clause
// Points that move straight beside few edges. See simd_gaps.h for Lanes.
#pragma once

#include "hierarchy/simd_gaps.h"

namespace tricover::detail::simd {

/// A way and an edge are apart by more than `reach` if one of three axes parts them by that: the edge's normal, the
/// edge, or the way's normal. Axes have other lengths than 1; what their gaps are compared with, at least as long.
///
/// Rounding, in units of 2^-24 and divided by the axis' length: a point's coordinates and a vertex' are rounded once,
/// the axis once, then come two products, two sums and the difference; so no gap is off by more than 8 (|p| + |v| +
/// |u|) where |v| + |u| is at most 4.
template <class Lanes>
void findEdgesOnWays(const FewEdges& edges, const FewWays& ways, unsigned* near) {
  constexpr float kRounding = 16 * static_cast<float>(kFloatRoundoff);
  const auto gap = [&](Lanes p, Lanes q, Lanes low, Lanes high) __attribute__((always_inline)) {
    return larger(low - larger(p, q), smaller(p, q) - high);
  };
  for (int k = 0; k < ways.count; ++k) {
    const float x = ways.x[k], y = ways.y[k], to_x = ways.to_x[k], to_y = ways.to_y[k];
    const float wx = to_x - x, wy = to_y - y, from = wx * y - wy * x;
    const float size = __builtin_fabsf(x) + __builtin_fabsf(y) + __builtin_fabsf(to_x) + __builtin_fabsf(to_y) + 4;
    const float reach = ways.reach[k] + kRounding * size;
    const Lanes way_reach = Lanes::all(reach * (__builtin_fabsf(wx) + __builtin_fabsf(wy) + 0x1p-60f));
    near[k] = 0;
    for (int i = 0; i < edges.lanes; i += kLanes) {
      const Lanes vx = Lanes::load(edges.x + i), vy = Lanes::load(edges.y + i);
      const Lanes ux = Lanes::load(edges.ux + i), uy = Lanes::load(edges.uy + i);
      const Lanes aside = Lanes::load(edges.aside + i), ahead = Lanes::load(edges.ahead + i);
      const Lanes beside = gap(ux * y - uy * x, ux * to_y - uy * to_x, aside, aside);
      const Lanes beyond = gap(ux * x + uy * y, ux * to_x + uy * to_y, ahead, ahead + Lanes::load(edges.square + i));
      const Lanes start = vy * wx - vx * wy, end = start + (uy * wx - ux * wy);
      const Lanes across = gap(start, end, Lanes::all(from), Lanes::all(from));
      const unsigned apart =
          above(larger(beside, beyond), Lanes::load(edges.length + i) * reach) | above(across, way_reach);
      near[k] |= (~apart & ((1u << kLanes) - 1)) << i;
    }
    near[k] &= (1u << edges.count) - 1;
  }
}

}  // namespace tricover::detail::simd
