// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apart/distance_search.h"
#include "hierarchy/unit_map.h"
#include "pair/posed_pair.h"

namespace tricover::detail {

/// For two small convex polygons that are clearly apart: shows the search the pairs of edges that can hold the least
/// distance, one as a rule. False, having shown nothing, if that isn't certain.
bool showNearestOfConvex(const PosedPair& pair, DistanceSearch& search);

}  // namespace tricover::detail
