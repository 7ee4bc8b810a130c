// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "polygon/polygon_data.h"

namespace tricover::detail {

/// The sine of the smallest turn of a clear corner.
constexpr double kClearCorner = 0x1p-19;

/// Whether a polygon is convex, and has an area: its one ring turns only left or only right, and goes around once. Its
/// straight and repeated vertices are no corners.
struct Convexity : Derived::Thing {
  explicit Convexity(const PolygonData& polygon);
  ~Convexity() override;

  int direction = 0;                  ///< 1 counter-clockwise, -1 clockwise, 0 not convex
  bool has_others = false;            ///< convex, and not all vertices are corners
  std::vector<EdgePosition> corners;  ///< if it has others: as positions in the path, which increase
  const PolygonData* by_corners;      ///< see cornersOf()
  /// If this is cornersOf() itself and all its corners are clear: from the line along any edge, the neighbours' other
  /// ends are at least that far away, but for a few roundings. Otherwise 0.
  double edge_depth = 0;
  Derived outline;  ///< by its corners alone, or of its hull
};

const Convexity& findConvexity(const PolygonData& polygon);

/// Exact. Found at the first call, in O(n), once for all copies and threads.
inline const Convexity& convexityOf(const PolygonData& polygon) {
  const auto* ready = static_cast<const Convexity*>(polygon.convexity.ifBuilt());
  return ready != nullptr ? *ready : findConvexity(polygon);
}

/// The polygon of a convex one's corners alone, which has the same region, S and unit: that polygon itself if all of
/// its vertices are corners. Null for a polygon that isn't convex.
inline const PolygonData* cornersOf(const PolygonData& polygon) {
  return polygon.isDegenerate() ? nullptr : convexityOf(polygon).by_corners;
}

/// Returns the edge beside p. The edges between the two positions in a ring's path are on a line.
EdgePosition edgeBeside(const PolygonData& polygon, std::size_t begin, std::size_t end, const Vec2& p);

/// Returns the number of the edge of a convex polygon, one with a length, that lies on edge k of cornersOf() beside p.
EdgeIndex edgeOfPath(const PolygonData& polygon, std::size_t k, const Vec2& p);

/// `taken` is the given polygon or its corners alone. Returns the number of the given polygon's edge that lies on the
/// taken one's edge, at a part of that from its start (0) to its end (1).
EdgeIndex givenEdge(const PolygonData& given, const PolygonData& taken, EdgePosition position, double part);

}  // namespace tricover::detail
