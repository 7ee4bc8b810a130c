// SPDX-License-Identifier: BSD-3-Clause
#include "hierarchy/inclusion.h"

#include "hierarchy/simd.h"

namespace tricover::detail {
namespace {

/// A triangle (s, v, w) holds the point only if the ray from the point away from s meets (v, w). Not inlined, because
/// bounding discs answer most points.
[[gnu::noinline]] Inclusion includeByRay(const PolygonData& polygon, const Hierarchy& hierarchy,
                                         const IncludedPoint& point) {
  const ApproxPoint& p = point.approx;
  CoveringSum sum(polygon, point);
  const Vec2 at = polygon.inUnits({p.x, p.y}), away = at - polygon.inUnits(sum.origin());
  // In either coordinate: what the point errs by, and three roundings of what is below 2.
  const double distance = away.norm(), error = p.error * polygon.inverse_unit + 0x1p-50;
  if (distance > 0x1p-10 && error < 0x1p-20 && polygon.fitsUnit()) {
    // The direction rotates by at most 4 error / distance, and nothing is farther away than 4.
    Ray ray{at.x(), at.y(), away.x() / distance, away.y() / distance, error * (2 + 16 / distance)};
    ray.for_winding = true;
    visitEdgesOnRay(
        hierarchy, ray, [](void* to, EdgePosition edge) { return static_cast<CoveringSum*>(to)->add(edge); }, &sum);
  } else {
    sum.addAll();  // rounding hides where the ray goes
  }
  return sum.result();
}

}  // namespace

Inclusion includeInDisc(const PolygonData& polygon, const Hierarchy* hierarchy, const IncludedPoint& point) {
  if (hierarchy != nullptr) return includeByRay(polygon, *hierarchy, point);
  CoveringSum sum(polygon, point);
  sum.addAll();
  return sum.result();
}

}  // namespace tricover::detail
