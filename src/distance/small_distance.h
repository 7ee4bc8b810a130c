// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "distance/distance_search.h"
#include "hierarchy/hierarchy.h"
#include "pair/posed_pair.h"

namespace tricover::detail {

inline bool areSmall(const PolygonData& a, const PolygonData& b) {
  return !a.isDegenerate() && !b.isDegenerate() && topOf(a).small && topOf(b).small;
}

/// Two small polygons (SmallPolygon) by all of their edges, without a tree: shows the search what it must see, if the
/// regions are certainly apart and not too far from each other. Otherwise nothing, and it returns false.
bool showSmall(const PosedPair& pair, DistanceSearch& search);

}  // namespace tricover::detail
