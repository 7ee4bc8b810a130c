// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "contact/crossings.h"

namespace tricover::detail {

/// A polyline along a polygon's ring, from one crossing with the other polygon's edges to the next, or all around.
struct InnerArc {
  /// Points [from, to] of InnerArcs::points.
  std::size_t from, to;
  bool is_known;        ///< whether the arc is certainly there; otherwise it may be
  EdgePosition met[2];  ///< the other polygon's edges that it meets at its ends; kNoEdge for a ring
};

/// The arcs of one side's rings that are, or may be, where the other side's polygon has its inside (or its outside).
/// Between two crossings an arc is there as a whole or not at all, and winding numbers are carried over crossings.
/// Without `has_windings` any arc may be there.
struct InnerArcs {
  InnerArcs(const PosedPair& pair, const WorldFrame& frame, const std::vector<EdgeCrossing>& crossings, int side,
            bool wants_inside, bool has_windings);

  std::vector<Vec2> points;         ///< in the WorldFrame
  std::vector<EdgePosition> edges;  ///< positions: that from point i to point i + 1
  std::vector<InnerArc> arcs;
};

}  // namespace tricover::detail
