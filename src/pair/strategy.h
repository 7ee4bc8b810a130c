// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pair/posed_pair.h"
#include "tricover/collide.h"

namespace tricover::detail {

/// What a query found, in a's frame and the pair's order.
struct Outcome {
  bool collides = false;
  /// Without a hit, a proven lower bound of the distance between any edge of a and any of b; on a hit without edges, of
  /// how far points may move until there is none. 0 if none was found.
  double clearance = 0;
  /// On a hit: the positions of two edges in reach of each other; or, in a containment, the contained ring's first edge
  /// and -1. Both -1 if inner discs answered, or boxes within the tolerance.
  std::ptrdiff_t edge_a = -1, edge_b = -1;
};

/// What a query wants to know beside the answer: nothing, how certain it is, or the edges of a hit. The less, the
/// shorter the ways to it.
enum class Wanted { Answer, Clearance, Edges };

/// The default: both hierarchies descended together. Whatever is farther apart than the margin by `lookahead` isn't
/// entered, so a clearance of at least that much is found if there is one. The bounding discs may meet.
Outcome collideByHierarchy(const PosedPair& pair, const CollideOptions& options, double lookahead, Wanted wanted);

/// Whether, no edges meeting, one region holds a ring of the other (repair 2): by one vertex of every ring. Leaves
/// clearance 0.
Outcome findContainment(const PosedPair& pair);

/// Algorithm 3 as printed, repaired; the cache's mask carries its coherence. The bounding discs may meet.
bool collideByPaper(const PosedPair& pair, PairCache* cache, const CollideOptions& options);

}  // namespace tricover::detail
