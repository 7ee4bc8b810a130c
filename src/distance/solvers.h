// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "convex/nearest_features.h"
#include "distance/distance_result.h"
#include "distance/options.h"
#include "polygon/cache_contents.h"

namespace tricover::detail {

// Each solver finds the distance of some pairs, and returns false for the others. `hint` may be null; otherwise it is
// tried first, and keeps what is found.

/// The distance of a point b from anything, beside its nearest edges; false where these do not tell.
bool pointDistance(const PosedVertices& pair, const DistanceQuery& options, DistanceResult& result);

/// The distance of two convex polygons without straight vertices (cornersOf()) that are clearly apart, or small ones
/// (SmallPolygon) that clearly meet.
bool convexDistance(const PosedVertices& pair, DistanceHint* hint, const DistanceQuery& options,
                    DistanceResult& result);

/// The distance of any polygons, by branch and bound over the pairs of their edges.
DistanceResult treeDistance(const PosedVertices& pair, DistanceHint* hint, const DistanceQuery& options);

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
