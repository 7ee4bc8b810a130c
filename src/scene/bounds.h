// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "hierarchy/axis_boxes.h"
#include "polygon/polygon_data.h"
#include "tricover/pose.h"

namespace tricover::detail {

/// Whether a polygon's vertices are asked for its bounds; otherwise its hierarchy is, and built, and they are wider.
inline bool hasFewVertices(const PolygonData& polygon) { return polygon.path.size() <= 400; }

/// A box around all points that are within `reach` of the posed polygon, rounded outwards. It never holds NaN.
Bounds boundsOf(const PolygonData& polygon, const Pose& pose, double reach);
/// The same around one edge, by its position.
Bounds boundsOfEdge(const PolygonData& polygon, std::size_t edge, const Pose& pose, double reach);

/// The box and what is within `reach` of it.
inline Bounds grown(const Bounds& box, double reach) {
  return {box.min_x - reach, box.min_y - reach, box.max_x + reach, box.max_y + reach};
}

}  // namespace tricover::detail
