// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "apart/edge_distance.h"
#include "hierarchy/wide.h"

namespace tricover::detail {

/// The nearest features of two convex polygons, by an edge of each that has the feature or starts with it; or edges
/// that cross.
struct ConvexFeatures {
  enum Kind : std::uint8_t { kNone, kEdgeOfA, kEdgeOfB, kVertices, kCrossing };
  Kind kind = kNone;  ///< of the first two: whose edge a vertex of the other is beside
  std::uint32_t edge_a = 0, edge_b = 0;
};

/// What separating axes tell of two small convex polygons.
struct ConvexNearest {
  Meeting meeting = Meeting::Unknown;
  ConvexFeatures features;            ///< the nearest; or edges that cross, none where one polygon lies in the other
  bool is_proven = false;             ///< whether those to be tried first were right
  bool is_unique = false;             ///< whether only those features can be the nearest, or cross
  EdgeDistances::Nearest nearest{};   ///< where they are, if so
  unsigned edges_a = 0, edges_b = 0;  ///< otherwise: bit per edge that can hold the least distance
  int inner_a = -1, inner_b = -1;     ///< an edge of the polygon that lies in the other one

  bool isInside() const { return inner_a >= 0 || inner_b >= 0; }
};

/// What is `found` stays Unknown where they aren't clearly apart, nor clearly meet. Features of other poses are tried
/// first.
void nearestOfConvex(const PlainWays& ways, const SmallRing& a, const SmallRing& b, const ConvexFeatures& tried,
                     const DistanceOptions& options, ConvexNearest& found);

}  // namespace tricover::detail
