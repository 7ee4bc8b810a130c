// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "tricover/export.h"
#include "tricover/polygon.h"

namespace tricover {

/// Where a point is. A point of an edge is Boundary even where the region lies on both of the edge's sides.
enum class Location { Outside, Boundary, Inside };

/// Where `point`, in the polygon's own frame, lies. Exact for every finite point.
///
/// This is the paper's Algorithm 1: the signs of the covering triangles that hold the point are summed, and the
/// polygon's fill rule says what the sum means. O(n).
///
/// Throws std::invalid_argument for a point that is not finite, and std::length_error as collide() does.
///
/// \snippet locate.cpp locate
TRICOVER_EXPORT Location locate(const Polygon& polygon, const Vec2& point);

/// What a moving point keeps between calls: its sign against the line of every edge (the paper's Algorithm 2).
/// PointCache{} is empty. It may serve another polygon from call to call.
struct PointCache {
  std::uint64_t polygon_id = 0;           ///< Polygon::id() of the polygon that the signs are about. 0: none.
  Location location = Location::Outside;  ///< Where all points with these signs are.
  std::vector<std::uint64_t> signs;       ///< Two bits an edge.
};

/// The same answer, with coherence. Points with equal signs against all edges' lines lie in one zone, and all of a zone
/// is at one location. So while no sign changes, the inclusion test is skipped.
///
/// \snippet locate.cpp locate with cache
TRICOVER_EXPORT Location locate(const Polygon& polygon, const Vec2& point, PointCache& cache);

}  // namespace tricover
