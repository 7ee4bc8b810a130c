// SPDX-License-Identifier: BSD-3-Clause
// Points that move straight beside at most 16 edges. See simd_gaps.h for Lanes.
#pragma once

#include "hierarchy/simd_gaps.h"

namespace tricover::detail::simd {

/// A path and an edge are apart by more than `reach` if one of three axes separates them by that: the edge's normal,
/// the edge, or the path's normal, of another length than 1, which its gap is compared with.
///
/// Rounding, in units of 2^-24 and divided by the axis' length: a point's coordinates and what is known of the edge are
/// rounded once, the axis once, the edge's middle three times more; then come two products, two sums and the
/// difference. So no gap is off by more than 12 (|p| + 4), as the edge and its middle are within 2 of S.
template <class Lanes>
void findEdgesOnPaths(const SmallPolygon& polygon, const StraightPaths& paths, unsigned* near) {
  constexpr float kRounding = 16 * static_cast<float>(kFloatRoundoff);
  for (int k = 0; k < paths.count; ++k) {
    const float x = paths.x[k], y = paths.y[k], to_x = paths.to_x[k], to_y = paths.to_y[k];
    const float wx = to_x - x, wy = to_y - y, from = wx * y - wy * x;
    const float size = __builtin_fabsf(x) + __builtin_fabsf(y) + __builtin_fabsf(to_x) + __builtin_fabsf(to_y) + 4;
    const float reach = (paths.reach[k] + kRounding * size) * (1 + 0x1p-20f);
    const float path_reach = reach * (__builtin_fabsf(wx) + __builtin_fabsf(wy) + 0x1p-60f);
    near[k] = 0;
    for (int i = 0; i < polygon.lanes; i += kLanes) {
      const Lanes nx = Lanes::load(polygon.nx + i), ny = Lanes::load(polygon.ny + i), d = Lanes::load(polygon.d + i);
      const Lanes middle = Lanes::load(polygon.middle + i), half = Lanes::load(polygon.half + i);
      const Lanes cx = nx * d - ny * middle, cy = ny * d + nx * middle;
      const Lanes n = nx * x + ny * y - d, n_end = nx * to_x + ny * to_y - d;
      const Lanes t = nx * y - ny * x - middle, t_end = nx * to_y - ny * to_x - middle;
      const Lanes beside = larger(smaller(n, n_end), Lanes::all(0) - larger(n, n_end));
      const Lanes beyond = larger(smaller(t, t_end), Lanes::all(0) - larger(t, t_end)) - half;
      const Lanes across = absolute(cy * wx - cx * wy - from) - half * absolute(nx * wx + ny * wy);
      const unsigned apart = above(larger(beside, beyond), Lanes::all(reach)) | above(across, Lanes::all(path_reach));
      near[k] |= (~apart & ((1u << kLanes) - 1)) << i & polygon.edges;
    }
  }
}

}  // namespace tricover::detail::simd
