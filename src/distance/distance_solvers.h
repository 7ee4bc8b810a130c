// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "distance/distance_query.h"
#include "distance/distance_result.h"
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

}  // namespace tricover::detail
