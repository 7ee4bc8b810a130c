// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "polygon/edge_position.h"

namespace tricover::detail {

/// What a query found, in the pair's order; lengths are the world's.
struct Outcome {
  bool collides = false;
  /// Without a hit, a proven lower bound of the distance between any edge of a and any of b; on a hit without edges, of
  /// how far points may move until there is none. 0 if none was found.
  double clearance = 0;
  /// On a hit: two edges in reach of each other; or, in a containment, the contained ring's first edge
  /// and kNoEdge. Both are kNoEdge if inner discs answered, or boxes within the tolerance.
  EdgePosition edge_a = kNoEdge, edge_b = kNoEdge;
};

}  // namespace tricover::detail
