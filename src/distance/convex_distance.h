// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "convex/feature_walk.h"
#include "convex/posed_vertices.h"
#include "distance/distance_result.h"
#include "distance/options.h"

namespace tricover::detail {

/// Of two strictly convex polygons that are clearly apart, or small ones (SmallPolygon) that clearly meet; nothing of
/// others. Keeps the features that it finds in `cache`, unless it is null, and tries those first.
std::optional<DistanceResult> convexDistance(const DistancePair& pair, const PosedVertices& vertices,
                                             DistanceFacts* cache, const DistanceQuery& options);

/// Where two strictly convex polygons meet.
struct ConvexOverlap {
  FeaturePair edges;               ///< that cross, or none
  EdgeDistance point{};            ///< where they do
  int inner_a = -1, inner_b = -1;  ///< otherwise: an edge of the polygon that lies in the other one

  bool isInside() const { return inner_a >= 0 || inner_b >= 0; }
  bool isFound() const { return edges.kind != FeaturePair::kNone || isInside(); }
};

/// Of those that seem to meet (NearestFeatures). Found only where that is certain, and both are small.
ConvexOverlap findConvexOverlap(const PosedVertices& vertices);

}  // namespace tricover::detail
