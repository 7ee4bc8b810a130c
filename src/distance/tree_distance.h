// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "distance/distance_result.h"
#include "distance/options.h"
#include "polygon/cache_contents.h"

namespace tricover::detail {

/// Of any polygons, by branch and bound over the pairs of their edges. Uses and renews the hint, unless it is null.
DistanceResult treeDistance(const PosedVertices& pair, DistanceHint* hint, const DistanceQuery& options);

}  // namespace tricover::detail
