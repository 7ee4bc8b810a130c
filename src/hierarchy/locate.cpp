// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/locate.h"

#include "hierarchy/hierarchy.h"
#include "hierarchy/inclusion.h"
#include "numbers/errors.h"
#include "numbers/rigidity.h"

namespace tricover {
namespace {

/// Null until the queries so far have cost as much as a tree (ski-rental).
const detail::Hierarchy* hierarchyInTime(const detail::PolygonData& polygon) {
  const detail::Hierarchy* built = detail::hierarchyIfBuilt(polygon);
  if (built != nullptr) return built;
  const bool is_due = polygon.hierarchy_rental.isDue(polygon.path.size(), detail::hierarchyPrice(polygon));
  return is_due ? &detail::hierarchyOf(polygon) : nullptr;
}

Location locateIncluded(const detail::PolygonData& polygon, const detail::IncludedPoint& point) {
  if (detail::outsideBoundingDisc(polygon, point.approx)) return detail::includeFarAway(polygon).location;
  return detail::locateInDisc(polygon, hierarchyInTime(polygon), point);
}

}  // namespace

Location locate(const Polygon& polygon, const Vec2& point) {
  detail::requireFinite(point, "point");
  return locateIncluded(detail::dataOf(polygon), detail::IncludedPoint::ofFrame(point));
}

Location locate(const Polygon& polygon, const Pose& pose, const Vec2& point) {
  static const Pose kWorld = Pose::Identity();
  detail::requireRigid(pose, "pose");
  detail::requireFinite(point, "point");
  const Vec2 way = point - pose.translation();
  const detail::ApproxPoint from_pose{way.x(), way.y(), 2 * detail::kUnitRoundoff * way.lpNorm<1>() + detail::kTiny};
  return locateIncluded(detail::dataOf(polygon), {&pose, detail::turnedBack(pose, from_pose), {&kWorld, point}});
}

}  // namespace tricover
