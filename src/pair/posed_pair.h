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

/// b's points as a's frame sees them: for the winding of a's rings around them.
class SeenFromA {
 public:
  explicit SeenFromA(const PosedPair& pair) : pair_(pair), back_(pair.pose_a) {}

  ApproxPoint at(const Vec2& local) const { return back_(pair_.fromB(local)); }
  /// The paper's Algorithm 1 under a's fill rule. Exact.
  Inclusion include(const Vec2& local) const;
  Location locate(const Vec2& local) const { return include(local).location; }
  int handed() const { return back_.handed; }

 private:
  const PosedPair& pair_;
  TurnBack back_;
};

}  // namespace tricover::detail
