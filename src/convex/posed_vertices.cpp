// SPDX-License-Identifier: BSD-3-Clause
#include "convex/posed_vertices.h"

namespace tricover::detail {

PosedVertices::Twofold2 PosedVertices::twofoldWay(std::size_t at_a, std::size_t at_b, double scale) const {
  Twofold2 way;
  detail::twofoldWay(pose_a.data(), load2(a.path[at_a].data()) * scale, pose_b.data(),
                     load2(b.path[at_b].data()) * scale, {shift_, shift_rest_}, way);
  return way;
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
