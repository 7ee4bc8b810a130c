// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "polygon/covering.h"

namespace tricover::detail {

/// Algorithm 1 on those edges only that a ray from the point meets, found by the hierarchy; on all of them where there
/// is none yet. Of many rings on those of the rings alone whose boxes may hold it; where one of these is large, once
/// that has been paid for, on those between the point and a known place near it: each block of the hierarchy has one.
/// Which way it is never changes an answer.
Inclusion includeInPolygon(const PolygonData& polygon, const IncludedPoint& point);

inline Location locateInPolygon(const PolygonData& polygon, const IncludedPoint& point) {
  return includeInPolygon(polygon, point).location;
}

/// Builds the known places, if there are many rings, and the hierarchy for them.
void buildPlaces(const PolygonData& polygon);

}  // namespace tricover::detail
