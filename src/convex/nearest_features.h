// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "convex/convex_ring.h"
#include "convex/posed_vertices.h"
#include "hierarchy/simd.h"

namespace tricover::detail {

/// A pair of features of two convex polygons: two vertices, or a vertex beside an edge; or edges that cross. Either is
/// given by an edge that it is, or that starts with it.
struct FeaturePair {
  enum Kind : std::uint8_t { kNone, kEdgeOfA, kEdgeOfB, kVertices, kCrossing };
  Kind kind = kNone;  ///< of the first two: whose edge a vertex of the other is beside
  EdgePosition edge_a = 0, edge_b = 0;
};

/// What separating axes prove of two convex polygons without straight vertices (cornersOf()).
struct NearestFeatures {
  bool are_apart = false;     ///< if not, nothing is proven: they may meet, or be too near to tell
  bool seem_to_meet = false;  ///< as far as floats see
  ConvexCrossing crossing;    ///< of small ones that do, a guess
  bool were_tried = false;    ///< whether those to be tried first are these, or led here

  // Of polygons apart.
  FeaturePair features;
  Foot foot;                   ///< of these
  bool is_unique = false;      ///< whether only these can be nearest
  RingRange edges_a, edges_b;  ///< if not: all edges that can hold the least distance
};

/// Features that were nearest at other poses are tried first.
NearestFeatures findNearestFeatures(const PosedVertices& vertices, const FeaturePair& tried);

}  // namespace tricover::detail
