// SPDX-License-Identifier: BSD-3-Clause
#include "hierarchy/inclusion.h"

#include "hierarchy/simd.h"

namespace tricover::detail {
namespace {

/// What the ray leads away from. Many rings may stand in rows with S among them, where each ring's ray away from S
/// would meet all those behind it: theirs lead out aslant.
Vec2 behindRay(const PolygonData& polygon, const Vec2& p) {
  constexpr std::size_t kManyRings = 16;
  if (polygon.ringCount() < kManyRings) return polygon.origin;
  const Vec2 away = polygon.inUnits(p), way = away + 0.31 * Vec2(-away.y(), away.x());
  const Vec2 behind = p - way * (polygon.unit / way.norm());
  return behind.allFinite() ? behind : polygon.origin;
}

/// A triangle (s, v, w) holds the point only if the ray from the point away from s meets (v, w). False if rounding
/// hides where that ray goes.
bool addAlongRay(CoveringSum& sum, const Hierarchy& hierarchy) {
  const PolygonData& polygon = sum.polygon();
  const ApproxPoint& p = sum.point().approx;
  // Beside the point's own error, of which a coordinate in units keeps a part: three roundings of what is below 2.
  const Vec2 at = polygon.inUnits({p.x, p.y}), away = at - polygon.inUnits(sum.origin());
  const double distance = away.norm(), error = p.error * polygon.inverse_unit + 0x1p-50;
  if (!(distance > 0x1p-10 && error < 0x1p-20 && polygon.fitsUnit())) return false;
  // The direction turns by at most 4 error / distance, and nothing is farther away than 4.
  const Ray ray{at.x(), at.y(), away.x() / distance, away.y() / distance, error * (2 + 16 / distance)};
  const auto add = [](void* context, std::uint32_t edge) { return static_cast<CoveringSum*>(context)->add(edge); };
  visitEdgesOnRay(hierarchy, ray, add, &sum);
  return true;
}

}  // namespace

Inclusion includeInPolygon(const PolygonData& polygon, const IncludedPoint& point) {
  if (outsideBoundingDisc(polygon, point.approx)) return {Location::Outside, 0};
  const Hierarchy* hierarchy = hierarchyIfBuilt(polygon);
  if (hierarchy == nullptr) return includeInCovering(polygon, point);
  CoveringSum sum(polygon, point, behindRay(polygon, {point.approx.x, point.approx.y}));
  if (!addAlongRay(sum, *hierarchy)) sum.addAll();
  return sum.result();
}

}  // namespace tricover::detail
