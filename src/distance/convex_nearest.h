// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "convex/convex_ring.h"
#include "distance/convex_features.h"
#include "distance/edge_distance.h"
#include "hierarchy/simd.h"

namespace tricover::detail {

/// What separating axes tell of two strictly convex polygons.
struct ConvexNearest {
  Meeting meeting = Meeting::Unknown;
  ConvexFeatures features;           ///< the nearest; or edges that cross, none where one polygon lies in the other
  bool is_proven = false;            ///< whether those to be tried first were right
  bool is_unique = false;            ///< whether only those features can be the nearest, or cross
  EdgeDistances::Nearest nearest{};  ///< where they are, if so
  RingRange edges_a, edges_b;        ///< otherwise: those that can hold the least distance
  int inner_a = -1, inner_b = -1;    ///< an edge of the polygon that lies in the other one

  bool isInside() const { return inner_a >= 0 || inner_b >= 0; }
};

/// What is `found` stays Unknown where they aren't clearly apart, nor small (SmallPolygon) and clearly meet. Features
/// of other poses are tried first.
void nearestOfConvex(const PlainWays& ways, const ConvexFeatures& tried, const DistanceOptions& options,
                     ConvexNearest& found);

}  // namespace tricover::detail
