// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apart/distance_search.h"
#include "hierarchy/wide.h"
#include "pair/posed_pair.h"

namespace tricover::detail {

/// For two small convex polygons, by separating axes. Where they are clearly apart, shows the search the pairs of edges
/// that can hold the least distance, one as a rule. Otherwise it has shown nothing.
Meeting showNearestOfConvex(const PosedPair& pair, DistanceSearch& search);

}  // namespace tricover::detail
