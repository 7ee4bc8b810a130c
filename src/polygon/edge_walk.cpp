// SPDX-License-Identifier: BSD-3-Clause
#include "polygon/edge_walk.h"

#include <algorithm>

namespace tricover::detail {

std::size_t edgeAfter(const PolygonData& polygon, std::size_t edge) {
  const std::size_t ring = polygon.ringOf(edge);
  return edge + 1 == polygon.edgeEnd(ring) ? polygon.edgeBegin(ring) : edge + 1;
}

std::size_t edgeBefore(const PolygonData& polygon, std::size_t edge) {
  const std::size_t ring = polygon.ringOf(edge);
  return (edge == polygon.edgeBegin(ring) ? polygon.edgeEnd(ring) : edge) - 1;
}

bool beginsPoint(const PolygonData& polygon, std::size_t v) {
  const std::size_t ring = polygon.ringOf(v);
  if (v != polygon.edgeBegin(ring)) return false;
  const Vec2 *const begin = polygon.path.begin() + v, *const end = polygon.path.begin() + polygon.edgeEnd(ring);
  return std::all_of(begin, end, [&](const Vec2& p) { return p == *begin; });
}

EdgesAt edgesAt(const PolygonData& polygon, std::size_t v) {
  const std::size_t ring = polygon.ringOf(v), begin = polygon.edgeBegin(ring), end = polygon.edgeEnd(ring);
  const auto hasLength = [&](std::size_t e) { return polygon.path[e] != polygon.path[e + 1]; };
  const auto previous = [&](std::size_t e) { return (e == begin ? end : e) - 1; };
  EdgesAt edges{v, previous(v)};
  if (hasLength(v)) {
    while (!hasLength(edges.before)) edges.before = previous(edges.before);
  } else if (hasLength(edges.before)) {
    while (!hasLength(edges.after)) edges.after = edges.after + 1 == end ? begin : edges.after + 1;
  }
  return edges;
}

}  // namespace tricover::detail
