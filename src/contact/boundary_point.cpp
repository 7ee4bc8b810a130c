// SPDX-License-Identifier: BSD-3-Clause
#include "contact/boundary_point.h"

#include <algorithm>

namespace tricover::detail {

std::size_t edgeAfter(const PolygonData& polygon, std::size_t edge) {
  const std::size_t ring = polygon.ringOf(edge);
  return edge + 1 == polygon.edgeEnd(ring) ? polygon.edgeBegin(ring) : edge + 1;
}

std::size_t edgeBefore(const PolygonData& polygon, std::size_t edge) {
  const std::size_t ring = polygon.ringOf(edge);
  return edge == polygon.edgeBegin(ring) ? polygon.edgeEnd(ring) - 1 : edge - 1;
}

bool beginsPoint(const PolygonData& polygon, std::size_t v) {
  const std::size_t ring = polygon.ringOf(v);
  if (v != polygon.edgeBegin(ring)) return false;
  const Vec2 *const begin = polygon.path.begin() + v, *const end = polygon.path.begin() + polygon.edgeEnd(ring);
  return std::all_of(begin, end, [&](const Vec2& p) { return p == *begin; });
}

BoundaryPoint vertexPoint(const PolygonData& polygon, int side, std::size_t v, const Vec2& at) {
  const std::size_t ring = polygon.ringOf(v), begin = polygon.edgeBegin(ring), end = polygon.edgeEnd(ring);
  const auto hasLength = [&](std::size_t e) { return polygon.path[e] != polygon.path[e + 1]; };
  const auto previous = [&](std::size_t e) { return (e == begin ? end : e) - 1; };
  std::size_t edge = v, before = previous(v);
  if (hasLength(v)) {
    while (!hasLength(before)) before = previous(before);
  } else if (hasLength(before)) {
    while (!hasLength(edge)) edge = edge + 1 == end ? begin : edge + 1;
  }
  const auto after = static_cast<std::int32_t>(edge), other = static_cast<std::int32_t>(before);
  return side == 0 ? BoundaryPoint{at, after, other, -1, -1} : BoundaryPoint{at, -1, -1, after, other};
}

}  // namespace tricover::detail
