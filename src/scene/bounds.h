// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "hierarchy/axis_boxes.h"
#include "polygon/polygon_data.h"
#include "tricover/pose.h"

namespace tricover::detail {

/// A box around all points that are within `reach` of the posed polygon, rounded outwards. It never holds NaN.
Bounds boundsOf(const PolygonData& polygon, const Pose& pose, double reach);
/// The same around one edge, by its position.
Bounds boundsOfEdge(const PolygonData& polygon, EdgePosition edge, const Pose& pose, double reach);

}  // namespace tricover::detail
