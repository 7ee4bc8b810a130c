// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "polygon/polygon_data.h"

namespace tricover::detail {

/// A convex polygon by its strictly convex corners, counter-clockwise in its own frame, as positions in the path. Two
/// of them are a line segment, one is a point.
struct ConvexOutline {
  std::vector<std::size_t> corners;
  bool is_region;  ///< the polygon's region is that convex set; otherwise it is the region's convex hull
};

/// O(n) for a convex polygon, O(n log n) for others. Exact.
ConvexOutline convexOutline(const PolygonData& polygon);

}  // namespace tricover::detail
