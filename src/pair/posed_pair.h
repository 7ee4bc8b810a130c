// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "hierarchy/placement.h"
#include "numbers/predicates.h"
#include "polygon/covering.h"

namespace tricover::detail {

/// Whether edge i of a and edge j of b (positions in the paths) share a point. Exact.
bool edgesMeet(const PosedPair& pair, std::size_t i, std::size_t j);

/// Whether they come within `reach` in the world. True is certain up to `reach`, and may be answered up to reach +
/// tolerance only. Exact where tolerance is 0. Strictly: whether they come nearer than a `reach` that isn't 0.
bool edgesWithin(const PosedPair& pair, std::size_t i, std::size_t j, double reach, double tolerance,
                 bool strictly = false);

/// Where the filters prove that two edges cross at a point inside both: 1 if, in the world, b's edge leads from the
/// right of a's to the left, -1 for the other way. Otherwise 0.
int crossingDirection(const PosedPair& pair, std::size_t i, std::size_t j);

/// How far each point of b may at least be moved before these two edges come apart; 0 where that isn't certain.
double crossingDepth(const PosedPair& pair, std::size_t i, std::size_t j);

/// A point of b as a's frame sees it: for the winding of a's rings around it.
inline IncludedPoint seenFromA(const PosedPair& pair, const Vec2& of_b) {
  return {&pair.pose_a, TurnBack(pair.pose_a)(pair.fromB(of_b)), {&pair.pose_b, of_b}};
}
/// Where that point is (the paper's Algorithm 1 under a's fill rule). Exact.
Location locateInA(const PosedPair& pair, const Vec2& of_b);

}  // namespace tricover::detail
