// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "numbers/predicates.h"
#include "pair/edge_pairs.h"
#include "polygon/edge_walk.h"

namespace tricover::detail {

// How a polygon's rings lie. Both are found at the first call, once for all copies and threads.

/// Whether edges of a polygon meet beyond the ends that they share in their ring, or vertices are repeated.
bool meetsItself(const PolygonData& polygon);

struct RegionSides {
  /// On which side of each ring's edges the region is, in the polygon's frame. 1: on the left; -1: on the right; 0: on
  /// both, or unknown, as where edges meet or rings are too many.
  std::vector<std::int8_t> rings;
  /// At so many corners, on average over directions, an edge of another region may lie against one of the rings.
  double corners = 0;
};
const RegionSides& regionSidesOf(const PolygonData& polygon);

/// The vertices' positions, but for those that close a ring; equal ones side by side.
std::vector<std::uint32_t> verticesByPlace(const PolygonData& polygon);

/// Whether two edges of a path have an end in common and nothing else.
inline bool meetAtVertex(const Path& path, EdgePosition e, EdgePosition f) {
  for (const std::size_t i : {e, e + 1})
    for (const std::size_t j : {f, f + 1})
      if (path[i] == path[j]) return orientation(path[i], path[2 * e + 1 - i], path[2 * f + 1 - j]) != 0;
  return false;
}

/// Calls visit(e, f), e < f, for a polygon's edges that meet in more than an end. visit returns whether to go on.
template <typename Visit>
void forEachOwnCrossing(const PolygonData& polygon, Visit visit) {
  const Pose still = Pose::Identity();
  const PosedPair itself(polygon, still, polygon, still);
  forEachPair(itself, 0, [&](double, EdgePosition e, EdgePosition f) {
    const bool meets = e < f && edgeAfter(polygon, e) != f && edgeAfter(polygon, f) != e &&
                       !meetAtVertex(polygon.path, e, f) && edgesMeet(itself, e, f);
    return meets && !visit(e, f) ? -1.0 : 0.0;
  });
}

}  // namespace tricover::detail
