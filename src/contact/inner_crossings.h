// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "contact/boundary_point.h"
#include "contact/crossings.h"
#include "pair/edge_sides.h"

namespace tricover::detail {

/// Where the outline of the overlap of the interiors is: see CrossingOptions::touching. Each edge is looked at once.
class InnerCrossings {
 public:
  /// crossings: all of the pair's.
  InnerCrossings(const PosedPair& pair, const std::vector<EdgeCrossing>& crossings)
      : pair_(pair), back_(pair.b, pair.pose_b, pair.a, pair.pose_a) {
    for (const EdgeCrossing& c : crossings) {
      met_[EdgeSides::A][c.edge_a].push_back(c.edge_b);
      met_[EdgeSides::B][c.edge_b].push_back(c.edge_a);
    }
  }

  /// Of two edges that meet.
  bool has(std::size_t edge_a, std::size_t edge_b) {
    return of(EdgeSides::A, edge_a).bordersBothAt(edge_b) || of(EdgeSides::B, edge_b).bordersBothAt(edge_a);
  }
  /// Whether it is at a vertex inside the other region, or along its edges as far as they lead without meeting the
  /// other polygon's edges.
  bool hasBeside(const BoundaryPoint& vertex) {
    return (vertex.b < 0 && hasBeside(EdgeSides::A, vertex.a, vertex.a_before)) ||
           (vertex.a < 0 && hasBeside(EdgeSides::B, vertex.b, vertex.b_before));
  }

 private:
  bool hasBeside(EdgeSides::Operand operand, std::int32_t after, std::int32_t before) {
    const auto edge = static_cast<std::size_t>(after), last = static_cast<std::size_t>(before);
    return of(operand, edge).bordersBothUntil(met_[operand][edge], 1) ||
           of(operand, last).bordersBothUntil(met_[operand][last], -1);
  }
  const EdgeSides& of(EdgeSides::Operand operand, std::size_t edge) {
    const auto known = known_[operand].find(edge);
    if (known != known_[operand].end()) return known->second;
    return known_[operand].emplace(edge, EdgeSides(pair_, back_, operand, edge)).first->second;
  }

  const PosedPair& pair_;
  const PosedPair back_;
  std::map<std::size_t, std::vector<std::size_t>> met_[2];  ///< by edge: the other polygon's edges that it meets
  std::map<std::size_t, EdgeSides> known_[2];
};

}  // namespace tricover::detail
