// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "polygon/polygon_data.h"

namespace tricover::detail {

/// A convex polygon by its strictly convex corners, counter-clockwise in its own frame, as positions in the path. Two
/// of them are a line segment, one is a point.
struct ConvexOutline : Derived::Thing {
  std::vector<std::size_t> corners;
  bool is_region = false;  ///< the polygon's region is that convex set; otherwise it is the region's convex hull
  /// Of a convex polygon with an area, all of whose vertices are corners: 1 where its ring runs counter-clockwise, -1
  /// where clockwise. Otherwise 0.
  int turn = 0;
};

/// Found at the first call, once for all copies and threads: O(n) for a convex polygon, O(n log n) for others. Exact.
const ConvexOutline& convexOutlineOf(const PolygonData& polygon);

}  // namespace tricover::detail
