// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "polygon/polygon_data.h"

namespace tricover::detail {

/// How a polygon is convex, if it is and has an area: one ring that turns one way and goes around once. Its straight
/// and repeated vertices are no corners.
struct Convexity {
  int direction = 0;                 ///< 1 counter-clockwise, -1 clockwise, 0 not convex
  std::vector<std::size_t> corners;  ///< strictly convex, in the ring's order, as positions in the path
};

/// Exact, O(n).
Convexity convexityOf(const PolygonData& polygon);

}  // namespace tricover::detail
