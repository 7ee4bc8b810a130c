// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>

#include "pair/edge_sides.h"

namespace tricover::detail {

/// Where the outline of the overlap of the interiors is: see CrossingOptions::touching. Each edge is looked at once.
class InnerCrossings {
 public:
  explicit InnerCrossings(const PosedPair& pair) : pair_(pair), back_(pair.b, pair.pose_b, pair.a, pair.pose_a) {}

  /// Of two edges that meet.
  bool has(std::size_t edge_a, std::size_t edge_b) {
    return of(EdgeSides::A, edge_a).bordersBothAt(edge_b) || of(EdgeSides::B, edge_b).bordersBothAt(edge_a);
  }
  /// Anywhere along an edge.
  bool has(EdgeSides::Operand operand, std::size_t edge) { return of(operand, edge).bordersBoth(); }

 private:
  const EdgeSides& of(EdgeSides::Operand operand, std::size_t edge) {
    const auto known = known_[operand].find(edge);
    if (known != known_[operand].end()) return known->second;
    return known_[operand].emplace(edge, EdgeSides(pair_, back_, operand, edge)).first->second;
  }

  const PosedPair& pair_;
  const PosedPair back_;
  std::map<std::size_t, EdgeSides> known_[2];
};

}  // namespace tricover::detail
