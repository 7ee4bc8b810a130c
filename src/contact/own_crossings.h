// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "contact/boundary_point.h"
#include "numbers/predicates.h"
#include "pair/edge_pairs.h"

namespace tricover::detail {

/// The vertices' positions, but for those that close a ring; equal ones side by side.
std::vector<std::uint32_t> verticesByPlace(const PolygonData& polygon);

/// Whether edges of a polygon meet beyond the ends that they share in their ring, or vertices are repeated. Found at
/// the first call, once for all copies and threads.
bool meetsItself(const PolygonData& polygon);

/// Whether two edges of a path have an end in common and nothing else.
inline bool meetAtVertex(const Path& path, std::size_t e, std::size_t f) {
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
  forEachPair(itself, 0, [&](double, std::size_t e, std::size_t f) {
    const bool meets = e < f && edgeAfter(polygon, e) != f && edgeAfter(polygon, f) != e &&
                       !meetAtVertex(polygon.path, e, f) && edgesMeet(itself, e, f);
    return meets && !visit(e, f) ? -1.0 : 0.0;
  });
}

}  // namespace tricover::detail
