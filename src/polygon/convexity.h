// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "polygon/polygon_data.h"

namespace tricover::detail {

/// Whether a polygon is convex, and has an area: one ring that turns one way and goes around once. Its straight and
/// repeated vertices are no corners.
struct Convexity : Derived::Thing {
  int direction = 0;                 ///< 1 counter-clockwise, -1 clockwise, 0 not convex
  bool is_strict = false;            ///< convex, and all vertices are corners
  std::vector<std::size_t> corners;  ///< in the ring's order, as positions in the path; none unless convex
  Derived outline;                   ///< by its corners alone, or of its hull
};

const Convexity& findConvexity(const PolygonData& polygon);

/// Exact. Found at the first call, in O(n), once for all copies and threads.
inline const Convexity& convexityOf(const PolygonData& polygon) {
  const auto* ready = static_cast<const Convexity*>(polygon.convexity.ifBuilt());
  return ready != nullptr ? *ready : findConvexity(polygon);
}

}  // namespace tricover::detail
