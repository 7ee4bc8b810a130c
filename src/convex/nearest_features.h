// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "convex/convex_ring.h"
#include "convex/feature_walk.h"
#include "convex/posed_vertices.h"
#include "hierarchy/simd.h"

namespace tricover::detail {

/// What separating axes prove of two convex polygons without straight vertices (cornersOf()).
struct NearestFeatures {
  bool are_apart = false;           ///< if not, nothing is proven: they may meet, or be too near to tell
  bool seem_to_meet = false;        ///< as far as floats see
  ConvexCrossing crossing{-1, -1};  ///< of small ones that do, a guess
  bool were_tried = false;          ///< whether those to be tried first led here in a few steps

  // Of polygons apart.
  FeaturePair features;
  Foot foot;                   ///< of these
  bool is_unique = false;      ///< whether only these can be nearest
  RingRange edges_a, edges_b;  ///< if not: all edges that can hold the least distance
};

/// Features that were nearest at other poses are tried first.
NearestFeatures findNearestFeatures(const PosedVertices& vertices, const FeaturePair& tried);

}  // namespace tricover::detail
