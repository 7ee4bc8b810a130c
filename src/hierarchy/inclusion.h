// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hierarchy/hierarchy.h"
#include "polygon/covering.h"

namespace tricover::detail {

/// Algorithm 1 on those edges only that a ray from the point meets, found by the hierarchy, without rings whose boxes
/// don't hold the point; on all edges where there is no hierarchy (null). The hierarchy never changes an answer.
Inclusion includeInDisc(const PolygonData& polygon, const Hierarchy* hierarchy, const IncludedPoint& point);

/// The same, after the bounding disc has been tested.
inline Inclusion includeInPolygon(const PolygonData& polygon, const IncludedPoint& point) {
  if (outsideBoundingDisc(polygon, point.approx)) return includeFarAway(polygon);
  return includeInDisc(polygon, hierarchyIfBuilt(polygon), point);
}

inline Location locateInPolygon(const PolygonData& polygon, const IncludedPoint& point) {
  return includeInPolygon(polygon, point).location;
}

}  // namespace tricover::detail
