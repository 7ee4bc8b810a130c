// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "apart/distance_search.h"
#include "hierarchy/wide.h"
#include "pair/outcome.h"
#include "pair/posed_pair.h"

namespace tricover::detail {

/// The nearest features of two convex polygons, by an edge of each that has the feature or starts with it.
struct ConvexFeatures {
  enum Kind : std::uint8_t { kNone, kEdgeOfA, kEdgeOfB, kVertices };
  Kind kind = kNone;  ///< whose edge a vertex of the other is beside
  std::uint32_t edge_a = 0, edge_b = 0;
  bool proven = false;  ///< whether they are the nearest once more
};

/// For two small convex polygons, by separating axes. Where they are clearly apart, shows the search the pairs of edges
/// that can hold the least distance, one as a rule. Otherwise it has shown nothing. The features that were the nearest
/// at other poses are tried first, and become those of now.
/// Where they meet, shows the search where, or tells by `inside` which one lies in the other, if that is easily seen.
Meeting showNearestOfConvex(const PosedPair& pair, DistanceSearch& search, ConvexFeatures& features, Outcome& inside);

}  // namespace tricover::detail
