// SPDX-License-Identifier: BSD-3-Clause
#include "polygon/edge_walk.h"

#include <algorithm>

namespace tricover::detail {

EdgePosition edgeAfter(const PolygonData& polygon, EdgePosition edge) {
  const std::size_t ring = polygon.ringOf(edge);
  return edge + 1 == polygon.edgeEnd(ring) ? polygon.edgeBegin(ring) : edge + 1;
}

EdgePosition edgeBefore(const PolygonData& polygon, EdgePosition edge) {
  const std::size_t ring = polygon.ringOf(edge);
  return (edge == polygon.edgeBegin(ring) ? polygon.edgeEnd(ring) : edge) - 1;
}

bool beginsPoint(const PolygonData& polygon, EdgePosition v) {
  const std::size_t ring = polygon.ringOf(v);
  if (v != polygon.edgeBegin(ring)) return false;
  const Vec2 *const begin = polygon.path.begin() + v, *const end = polygon.path.begin() + polygon.edgeEnd(ring);
  return std::all_of(begin, end, [&](const Vec2& p) { return p == *begin; });
}

EdgesAt edgesAt(const PolygonData& polygon, EdgePosition v) {
  const auto hasLength = [&](EdgePosition e) { return polygon.path[e] != polygon.path[e + 1]; };
  EdgePosition before = edgeBefore(polygon, v);
  if (hasLength(v))
    while (!hasLength(before)) before = edgeBefore(polygon, before);
  return {hasLength(before) ? polygon.namedEdge(v) : v, before};  // v where only repetitions are on both sides
}

}  // namespace tricover::detail
