// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hierarchy/hierarchy.h"
#include "hierarchy/influence_field.h"
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

/// Where the point is: by the field, if that tells, otherwise as above.
inline Location locateInDisc(const PolygonData& polygon, const Hierarchy* hierarchy, const IncludedPoint& point) {
  constexpr std::size_t kWithoutField = 64;
  if (const InfluenceField* field = hierarchy != nullptr ? fieldIfPaid(polygon, kWithoutField) : nullptr) {
    const Vec2 at = polygon.inUnits({point.approx.x, point.approx.y});
    const double error = 4 * kUnitRoundoff * at.lpNorm<1>() + point.approx.error * polygon.inverse_unit + kTiny;
    const InfluenceField::Look look = field->at(at.x(), at.y());
    if (look.free > error) return look.inside ? Location::Inside : Location::Outside;
  }
  return includeInDisc(polygon, hierarchy, point).location;
}

inline Location locateInPolygon(const PolygonData& polygon, const IncludedPoint& point) {
  if (outsideBoundingDisc(polygon, point.approx)) return includeFarAway(polygon).location;
  return locateInDisc(polygon, hierarchyIfBuilt(polygon), point);
}

}  // namespace tricover::detail
