// SPDX-License-Identifier: BSD-3-Clause
#include "convex/posed_vertices.h"

#include <algorithm>

#include "hierarchy/simd.h"

namespace tricover::detail {

PosedVertices::Twofold2 PosedVertices::twofoldWay(std::size_t at_a, std::size_t at_b, double scale) const {
  Twofold2 way;
  detail::twofoldWay(pose_a.data(), load2(a.path[at_a].data()), pose_b.data(), load2(b.path[at_b].data()), scale, way);
  return way;
}

double PosedVertices::twofoldDistance(bool edge_of_a, int place, bool at_end, EdgePosition edge, std::size_t vertex,
                                      double scale, double& part) const {
  const auto from = [&](bool end) {
    const std::size_t v = edge + (end ? 1 : 0);
    return edge_of_a ? twofoldWay(v, vertex, scale) : twofoldWay(vertex, v, scale);
  };
  const auto toEnd = [&part](const Twofold2& w, bool end) {
    part = end ? 1 : 0;
    return std::sqrt(dot(w.high, w.high));
  };
  const Twofold2 w = from(at_end);
  if (place == -1 || place == 1) return toEnd(w, at_end);
  const Vec2* path = (edge_of_a ? a : b).path.data() + edge;
  const double* r = (edge_of_a ? pose_a : pose_b).data();
  const Double2 v1 = load2(path[0].data()) * scale, v2 = load2(path[1].data()) * scale;
  if (place == 0) {
    const Double2 along = v2 - v1, plain = load2(r) * along[0] + load2(r + 3) * along[1];
    const double d = std::abs(cross(plain, w.high)) / std::sqrt(dot(plain, plain));
    if (dot(w.high, w.high) <= kSteepest * kSteepest * d * d) return d;
  }
  Double2 u;
  const double area = twofoldArea(r, v1, v2, w, u), square = dot(u, u);
  if (!(square > 0x1p-900)) return square == 0 ? toEnd(w, false) : 0;
  if (place != 0) {
    const Twofold2 other = from(!at_end), &w1 = at_end ? other : w, &w2 = at_end ? w : other;
    const double sign = edge_of_a ? 1 : -1, along = sign * dot(w1.high, u);
    if (along <= 0) return toEnd(w1, false);
    if (sign * dot(w2.high, u) >= 0) return toEnd(w2, true);
    part = std::min(along / square, 1.0);
  }
  return std::abs(area) / std::sqrt(square);
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
