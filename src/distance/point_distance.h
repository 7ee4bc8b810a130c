// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "numbers/double2.h"
#include "polygon/polygon_data.h"
#include "tricover/pose.h"

namespace tricover::detail {

/// A point in the world, rounded as a posed vertex is.
inline Vec2 posed(const Pose& pose, const Vec2& p) {
  const double* m = pose.data();  // columns of three
  Vec2 point;
  store2(point.data(), (load2(m) * p.x() + load2(m + 3) * p.y()) + load2(m + 6));
  return point;
}

/// The distance of two points by plain doubles, as exact as EdgeDistances::at(); negative where that isn't certain.
double plainDistance(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b);

/// Where a polygon's edges are nearest to a point, as exact as EdgeDistances::at().
struct NearestEdge {
  double distance;        ///< negative where plain doubles don't do; nothing else is told then
  std::size_t edge;       ///< position in a's path
  Vec2 point_a, point_b;  ///< in the world, rounded as posed vertices are
  bool may_be_inside;     ///< the point isn't certainly outside of the region
};

/// Of a point b and a polygon a that is none, nor a segment.
NearestEdge nearestEdge(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b);

}  // namespace tricover::detail
