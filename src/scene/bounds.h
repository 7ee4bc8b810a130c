// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>

#include "hierarchy/axis_boxes.h"
#include "polygon/polygon_data.h"
#include "tricover/pose.h"

namespace tricover::detail {

/// How far points may be from where hierarchies and timeOfImpact() take them to be: anywhere, for the largest of
/// polygons. Boxes that must hold what they may report are without ends then.
inline double errorOfLargest(const PolygonData& polygon) {
  return polygon.fitsUnit() ? 0 : std::numeric_limits<double>::infinity();
}

/// A box around all points that are within `reach` of the posed polygon, rounded outwards. It never holds NaN.
Bounds boundsOf(const PolygonData& polygon, const Pose& pose, double reach);
/// The same around one edge, by its position.
Bounds boundsOfEdge(const PolygonData& polygon, EdgePosition edge, const Pose& pose, double reach);

}  // namespace tricover::detail
