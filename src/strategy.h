// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "posed_pair.h"
#include "tricover/collide.h"

namespace tricover::detail {

/// What a query found, in a's frame and the pair's order.
struct Outcome {
  bool collides = false;
  /// Proven lower bound of the distance between any edge of a and any of b; 0 if none was found.
  double clearance = 0;
  /// On a hit: the positions of two edges in reach of each other; or, in a containment, the contained ring's first edge
  /// and -1. Both -1 if the boxes answered within the tolerance.
  std::ptrdiff_t edge_a = -1, edge_b = -1;
};

/// The default: both hierarchies descended together. Whatever is farther apart than the margin by `lookahead` isn't
/// entered, so a clearance of at least that much is found if there is one. The bounding discs may meet.
Outcome collideByHierarchy(const PosedPair& pair, const CollideOptions& options, double lookahead);

/// Whether, no edges meeting, one region holds a ring of the other (repair 2): by one vertex of every ring. Leaves
/// clearance 0.
Outcome findContainment(const PosedPair& pair);

/// Whether the cache is about this pair; otherwise it is emptied and becomes so.
bool recall(PairCache& cache, const PosedPair& pair);

/// Algorithm 3 as printed, repaired; the cache's mask carries its coherence. The bounding discs may meet.
bool collideByPaper(const PosedPair& pair, PairCache* cache, const CollideOptions& options);

}  // namespace tricover::detail
