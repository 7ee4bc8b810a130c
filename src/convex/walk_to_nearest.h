// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "convex/nearest_features.h"
#include "convex/posed_ring.h"

namespace tricover::detail {

/// The nearest features of two convex rings that are apart, as far as plain doubles see: a guess. As GJK does, it turns
/// the axis between two vertices until these are the nearest, from the support vertices along `n` on, an axis from a to
/// b; those are found in O(log n) steps. way(v, w) leads from a's vertex v to b's vertex w.
//
// Let n be an axis from a to b, v the support vertex of a along n, w that of b along -n, and x = w - v. The gap along
// n is n . x. Its greatest value is the distance, and n grows towards it by turning towards x. Meanwhile v and w change
// where n is across an edge that ends there. Which edge comes next, the directions of the two edges tell. Before it,
//   x doesn't lead along the edge       the greatest gap was passed: it is between v and w;
// and otherwise, with the edge's other end for v or w,
//   x no longer leads along the edge    the greatest gap is across this edge;
//   x still does                        it comes later.
template <typename Way>
[[gnu::noinline]] FeaturePair walkToNearest(const PosedRing& a, const PosedRing& b, Double2 n, Way way) {
  std::uint32_t v = a.supportVertex(n), w = b.supportVertex(-n);
  Double2 x = way(v, w);
  const bool ccw = cross(n, x) > 0;
  std::uint32_t next_v = a.next(v, ccw), next_w = b.next(w, ccw);
  Double2 of_a = a.way(v, next_v), of_b = b.way(next_w, w);
  for (std::uint32_t steps = a.ring.size() + b.ring.size() + 2; steps > 0; --steps) {
    const double turn = cross(of_a, of_b);
    const bool is_a = ccw ? turn > 0 : turn < 0;
    const Double2 edge = is_a ? of_a : of_b;
    const bool is_beyond = ccw ? cross(edge, x) < 0 : cross(edge, x) > 0;
    if (!(dot(edge, x) > 0)) return {is_beyond || dot(n, x) > 0 ? FeaturePair::kVertices : FeaturePair::kNone, v, w};
    x -= edge;
    const bool is_before = dot(edge, x) > 0;
    if (!is_before && !is_beyond) return {};
    if (!is_before && is_a) return {FeaturePair::kEdgeOfA, a.isForward(ccw) ? v : next_v, w};
    if (!is_before) return {FeaturePair::kEdgeOfB, v, b.isForward(ccw) ? w : next_w};
    if (is_a) {
      v = next_v;
      next_v = a.next(v, ccw);
      of_a = a.way(v, next_v);
    } else {
      w = next_w;
      next_w = b.next(w, ccw);
      of_b = b.way(next_w, w);
    }
  }
  return {};
}

}  // namespace tricover::detail
