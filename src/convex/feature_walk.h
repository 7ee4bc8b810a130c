// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "convex/posed_vertices.h"

namespace tricover::detail {

/// A pair of features of two convex polygons: two vertices, or a vertex beside an edge; or edges that cross. Either is
/// given by an edge that it is, or that starts with it.
struct FeaturePair {
  enum Kind : std::uint8_t { kNone, kEdgeOfA, kEdgeOfB, kVertices, kCrossing };
  Kind kind = kNone;  ///< of the first two: whose edge a vertex of the other is beside
  std::uint32_t edge_a = 0, edge_b = 0;
};

/// The nearest features of convex polygons without straight vertices (cornersOf()) that are apart, as far as plain
/// doubles see: a guess. As GJK does, it turns the axis between two vertices until these are the nearest, from the
/// vertices on that face the other polygon's origin; those are found in O(log n) steps.
FeaturePair walkToNearest(const PosedVertices& vertices);

}  // namespace tricover::detail
