// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "convex/convex_ring.h"
#include "polygon/convexity.h"

namespace tricover::detail {

/// A convex polygon by its strictly convex corners, counter-clockwise in its own frame from the leftmost one on. Two of
/// them are a line segment, one is a point.
struct ConvexOutline : Derived::Thing {
  ConvexRing ring() const { return {points.data(), corners.size(), 1}; }

  std::vector<EdgePosition> corners;  ///< positions in the path
  std::vector<Vec2> points;           ///< where they are, the first once more at the end
  bool is_region = false;  ///< the polygon's region is that convex set; otherwise it is the region's convex hull
  bool forward = true;     ///< of a region: whether the path runs counter-clockwise
};

const ConvexOutline& findConvexOutline(const PolygonData& polygon);

/// Found at the first call, once for all copies and threads: O(n) for a convex polygon, O(n log n) for others. Exact.
inline const ConvexOutline& convexOutlineOf(const PolygonData& polygon) {
  const auto* ready = static_cast<const ConvexOutline*>(convexityOf(polygon).outline.ifBuilt());
  return ready != nullptr ? *ready : findConvexOutline(polygon);
}

/// The edge of a convex region's path that edge k of its outline is; of several, which straight vertices divide, the
/// one nearest to p.
EdgePosition pathEdge(const PolygonData& polygon, const ConvexOutline& outline, std::size_t k, const Vec2& p);

}  // namespace tricover::detail
