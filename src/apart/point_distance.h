// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "polygon/polygon_data.h"
#include "tricover/pose.h"

namespace tricover::detail {

/// The distance of two points by plain doubles, as exact as EdgeDistances::at(); negative where that isn't certain.
double plainDistance(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b);

/// Where a polygon's edges are nearest to a point, as exact as EdgeDistances::at().
struct NearestEdge {
  double distance;     ///< negative where plain doubles don't do; nothing else is told then
  std::size_t edge;    ///< position in a's path
  double along;        ///< the nearest point on it, from its start (0) to its end (1)
  bool may_be_inside;  ///< the point isn't certainly outside of the region
};

/// Of a point b and a polygon a that is none, nor a segment.
NearestEdge nearestEdge(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b);

}  // namespace tricover::detail
