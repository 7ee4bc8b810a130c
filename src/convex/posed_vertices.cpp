// SPDX-License-Identifier: BSD-3-Clause
#include "convex/posed_vertices.h"

#include "hierarchy/simd.h"

namespace tricover::detail {

PosedVertices::Twofold2 PosedVertices::twofoldWay(std::size_t at_a, std::size_t at_b, double scale) const {
  Twofold2 way;
  detail::twofoldWay(pose_a.data(), load2(a.path[at_a].data()), pose_b.data(), load2(b.path[at_b].data()), scale, way);
  return way;
}

double PosedVertices::distanceBeside(bool edge_of_a, bool at_end, std::size_t edge, std::size_t vertex,
                                     double scale) const {
  const std::size_t end = edge + (at_end ? 1 : 0);
  const Twofold2 w = edge_of_a ? twofoldWay(end, vertex, scale) : twofoldWay(vertex, end, scale);
  const Vec2* path = (edge_of_a ? a : b).path.data() + edge;
  const double* r = (edge_of_a ? pose_a : pose_b).data();
  const Double2 v1 = load2(path[0].data()) * scale, v2 = load2(path[1].data()) * scale, along = v2 - v1,
                plain = load2(r) * along[0] + load2(r + 3) * along[1];
  const double d = std::abs(cross(plain, w.high)) / std::sqrt(dot(plain, plain));
  if (dot(w.high, w.high) <= kSteepest * kSteepest * d * d) return d;
  Double2 u;
  const double area = twofoldArea(r, v1, v2, w, u), square = dot(u, u);
  return square > 0x1p-900 ? std::abs(area) / std::sqrt(square) : 0;
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
