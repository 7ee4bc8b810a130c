// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "polygon/covering.h"

namespace tricover::detail {

/// Algorithm 1 on those edges only that a ray from the point meets, found by the hierarchy, without rings whose boxes
/// don't hold the point; on all edges where there is no hierarchy yet. The hierarchy never changes an answer.
Inclusion includeInPolygon(const PolygonData& polygon, const IncludedPoint& point);

inline Location locateInPolygon(const PolygonData& polygon, const IncludedPoint& point) {
  return includeInPolygon(polygon, point).location;
}

}  // namespace tricover::detail
