// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "tricover/polygon.h"

namespace tricover {

/// Where a point is; an edge is Boundary even where the region lies on both of its sides.
enum class Location { Outside, Boundary, Inside };

/// Where `point` (in the polygon's own frame) lies: the paper's Algorithm 1, the sum of the signs of the covering
/// triangles that hold the point, under the polygon's fill rule. Exact for every finite point; O(n).
/// Throws std::invalid_argument if a coordinate is not finite.
Location locate(const Polygon& polygon, const Vec2& point);

/// What a moving point keeps between calls (the paper's Algorithm 2): its sign against every edge's line, two bits an
/// edge. Empty at first; the polygon may change from call to call.
struct PointCache {
  std::uint64_t polygon_id = 0;           ///< whose edges the signs are about (0: none)
  Location location = Location::Outside;  ///< of the zone that has these signs
  std::vector<std::uint64_t> signs;       ///< two bits an edge
};

/// The same answer, with coherence: while no sign changes the point stays in its zone (a face of the arrangement of the
/// edges' lines, on which the location is constant) and the inclusion test is skipped.
Location locate(const Polygon& polygon, const Vec2& point, PointCache& cache);

}  // namespace tricover
