// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "distance/plain_ways.h"

namespace tricover::detail {

/// The nearest features of two convex polygons, by an edge of each that has the feature or starts with it; or edges
/// that cross.
struct ConvexFeatures {
  enum Kind : std::uint8_t { kNone, kEdgeOfA, kEdgeOfB, kVertices, kCrossing };
  Kind kind = kNone;  ///< of the first two: whose edge a vertex of the other is beside
  std::uint32_t edge_a = 0, edge_b = 0;
};

/// Those of strictly convex polygons (Hierarchy::strictly_convex) that are apart, as far as plain doubles see: a guess.
/// O(log n) steps, and those from the vertices that face the other polygon's origin.
ConvexFeatures guessNearest(const PlainWays& ways);

}  // namespace tricover::detail
