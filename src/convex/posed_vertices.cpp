// SPDX-License-Identifier: BSD-3-Clause
#include "convex/posed_vertices.h"

namespace tricover::detail {

// Vectors go from a to b whatever the edge is of, so that two vertices are found just as far apart from either's edges.
// Each of the four products and four sums is at most M, the size, and rounds by U M, which is kept in the low parts, as
// is what t was rounded by; their own eight sums round by U of at most 9U M.
PosedVertices::Twofold2 PosedVertices::twofoldWay(std::size_t at_a, std::size_t at_b, double scale) const {
  const auto both = [](double x) { return Double2{x, x}; };
  const double *ra = pose_a.data(), *rb = pose_b.data();  // columns of three
  const Double2 q = load2(b.path[at_b].data()) * scale, p = load2(a.path[at_a].data()) * scale;
  const Twofold2 b0 = twoProduct(load2(rb), both(q[0])), b1 = twoProduct(load2(rb + 3), both(q[1]));
  const Twofold2 a0 = twoProduct(load2(ra), both(p[0])), a1 = twoProduct(load2(ra + 3), both(p[1]));
  const Twofold2 of_b = twoSum(b0.high, b1.high), of_a = twoSum(a0.high, a1.high);
  const Twofold2 of_both = twoSum(of_b.high, -of_a.high), w = twoSum(shift_, of_both.high);
  const Double2 rests = (b0.low + b1.low) - (a0.low + a1.low), sums = (of_b.low - of_a.low) + (of_both.low + w.low);
  return twoSum(w.high, rests + (sums + shift_rest_));
}

Foot PosedVertices::twofoldBetween(std::size_t p, std::size_t q) const {
  const Double2 w = twofoldWay(p, q, 1).high, squares = w * w;
  const double distance = std::sqrt(squares[0] + squares[1]);
  // sqrt2 100 U^2 of the size, and 2U for squares, sum and root.
  static_assert(kRoot2 * 100 * kUnitRoundoff * kUnitRoundoff <= kUnitRoundoff * kLeastShare &&
                kRelativeError >= errorOf(1 + 1 + 2));
  return {distance, 0, 0, 0, w * (1 / distance), false, distance >= kLeastShare * size_};
}

}  // namespace tricover::detail
