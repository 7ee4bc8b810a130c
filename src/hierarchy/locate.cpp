// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/locate.h"

#include "hierarchy/hierarchy.h"
#include "hierarchy/inclusion.h"
#include "numbers/errors.h"

namespace tricover {
namespace {

/// Null until the queries so far have cost as much as a tree (ski-rental).
const detail::Hierarchy* hierarchyInTime(const detail::PolygonData& polygon) {
  const detail::Hierarchy* built = detail::hierarchyIfBuilt(polygon);
  if (built != nullptr) return built;
  const bool is_due = polygon.hierarchy_rental.isDue(polygon.path.size(), detail::hierarchyPrice(polygon));
  return is_due ? &detail::hierarchyOf(polygon) : nullptr;
}

}  // namespace

Location locate(const Polygon& polygon, const Vec2& point) {
  detail::requireFinite(point, "point");
  const detail::PolygonData& data = polygon.data();
  const detail::IncludedPoint included = detail::IncludedPoint::ofFrame(point);
  if (detail::outsideBoundingDisc(data, included.approx)) return detail::includeFarAway(data).location;
  return detail::locateInDisc(data, hierarchyInTime(data), included);
}

}  // namespace tricover
