// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "convex/nearest_features.h"
#include "distance/distance_result.h"
#include "distance/options.h"
#include "polygon/cache_contents.h"

namespace tricover::detail {

/// Of two convex polygons without straight vertices (cornersOf()) that are clearly apart, or small ones (SmallPolygon)
/// that clearly meet; false of others. Tries the features of the hint first and keeps those that it finds there,
/// unless `hint` is null.
bool convexDistance(const PosedVertices& pair, DistanceHint* hint, const DistanceQuery& options,
                    DistanceResult& result);

/// Where two convex polygons meet.
struct ConvexOverlap {
  FeaturePair edges;               ///< that cross, or none
  EdgeDistance point;              ///< where they do
  int inner_a = -1, inner_b = -1;  ///< otherwise: an edge of the polygon that lies in the other one

  bool isInside() const { return inner_a >= 0 || inner_b >= 0; }
  bool isFound() const { return edges.kind != FeaturePair::kNone || isInside(); }
};

/// Of those that seem to meet, where floats see them cross (NearestFeatures). Found only where that is certain.
void findConvexOverlap(const PosedVertices& pair, const ConvexCrossing& crossing, ConvexOverlap& found);

}  // namespace tricover::detail
