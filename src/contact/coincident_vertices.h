// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "contact/crossings.h"
#include "contact/world_frame.h"
#include "hierarchy/simd.h"

namespace tricover::detail {

/// The positions of a path's vertices, equal ones side by side.
std::vector<std::uint32_t> sortedByPlace(const Path& path);

/// Whether the vertex at a position begins a ring that is one point.
bool beginsPoint(const PolygonData& polygon, std::size_t v);

/// Points where several vertices of either polygon meet. All edges that end at such a point meet there in pairs; to
/// know them together, those pairs are enough that one edge of either polygon has with all of the other's.
class CoincidentVertices {
 public:
  explicit CoincidentVertices(const PosedPair& pair);

  /// Of the pairs of vertices at which some edges meet, the one that most edges share; both -1 if there is none.
  std::pair<std::ptrdiff_t, std::ptrdiff_t> largest(const std::vector<EdgeCrossing>& crossings) const;

  /// Chooses the two edges whose pairs tell of the point that the vertices u of a and v of b are at.
  void tellBy(std::size_t u, std::size_t v, std::size_t edge_a, std::size_t edge_b);

  /// Whether these edges meet in one such point only, and the pairs of others tell. Otherwise nothing is said.
  bool isKnown(std::size_t i, std::size_t j);

 private:
  enum State : char { New, Apart, Met };
  struct MetEdges {
    State state = New;
    std::size_t edge_a = 0, edge_b = 0;  ///< those whose pairs count
  };

  bool isOne(std::size_t u, std::size_t v) const;

  const PosedPair& pair_;
  std::vector<std::uint32_t> place_a_, place_b_;  ///< by position: equal for equal vertices
  std::unordered_map<std::uint64_t, MetEdges> meetings_;
};

/// The boxes of edges that end in one point of many, for two polygons or for one with itself: met with each other they
/// would show nothing but that point.
class IncidentEdgeBoxes {
 public:
  /// Around the vertices u of a and v of b, which are one point; but for one edge of either, whose pairs tell of it.
  IncidentEdgeBoxes(const PosedPair& pair, const WorldFrame& frame, std::size_t u, std::size_t v,
                    CoincidentVertices& coincident);
  /// Around a polygon's vertex v; other pairs aren't needed to tell of it.
  IncidentEdgeBoxes(const PolygonData& polygon, std::size_t v);

  PrunedPairs pairs() const {
    return a_.empty() ? PrunedPairs{} : PrunedPairs{a_.data(), b_.empty() ? a_.data() : b_.data()};
  }

 private:
  std::vector<std::uint8_t> a_, b_;
};

}  // namespace tricover::detail
