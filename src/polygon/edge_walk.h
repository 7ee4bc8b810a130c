// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "polygon/polygon_data.h"

namespace tricover::detail {

/// A point that is ordered by x, then by y, which is the order along any line.
using OrderedPoint = std::array<double, 2>;
inline OrderedPoint ordered(const Vec2& p) { return {p.x(), p.y()}; }

/// Calls visit(edge), a position in the path, for every edge, ring by ring, until it returns false.
template <typename Visit>
void forEachEdge(const PolygonData& polygon, Visit&& visit) {
  for (std::size_t ring = 0; ring < polygon.ringCount(); ++ring)
    for (EdgePosition edge = polygon.edgeBegin(ring); edge < polygon.edgeEnd(ring); ++edge)
      if (!visit(edge)) return;
}

/// The next edge of a ring, all around, and the one before; positions in the path.
EdgePosition edgeAfter(const PolygonData& polygon, EdgePosition edge);
EdgePosition edgeBefore(const PolygonData& polygon, EdgePosition edge);

/// Whether the vertex at a position begins a ring that is one point.
bool beginsPoint(const PolygonData& polygon, EdgePosition v);

/// The edge that leaves a vertex and the one that leads to it, beyond repetitions of it.
struct EdgesAt {
  EdgePosition after, before;
};
EdgesAt edgesAt(const PolygonData& polygon, EdgePosition v);

/// Returns the one of the two edges at a vertex that is more across a direction: where a whole edge is deepest, that.
/// endsOf(edge) has an edge's ends v and w, in the direction's frame.
template <typename EndsOf>
EdgePosition flatterEdge(const EdgesAt& at, const Vec2& direction, EndsOf endsOf) {
  if (at.after == at.before) return at.after;
  const auto slope = [&](EdgePosition edge) {
    const auto ends = endsOf(edge);
    const Vec2 way = ends.w - ends.v;
    return way.isZero(0) ? 1 : std::abs(way.stableNormalized().dot(direction));
  };
  return slope(at.before) < slope(at.after) ? at.before : at.after;
}

}  // namespace tricover::detail
