// SPDX-License-Identifier: BSD-3-Clause
#include <fcl/geometry/shape/halfspace.h>
#include <fcl/geometry/shape/plane.h>

#include <algorithm>
#include <cmath>

#include "shadow.h"

namespace tricover_fcl {
namespace {

using tricover::Ring;
using tricover::Vec2;

/// What of a convex ring lies in normal . x <= offset.
Ring clip(const Ring& ring, const Vec2& normal, double offset) {
  Ring kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &v = ring[i], &w = ring[(i + 1) % ring.size()];
    const double above_v = normal.dot(v) - offset, above_w = normal.dot(w) - offset;
    if (above_v <= 0) kept.push_back(v);
    if ((above_v < 0 && above_w > 0) || (above_v > 0 && above_w < 0))
      kept.push_back(v + above_v / (above_v - above_w) * (w - v));
  }
  return kept;
}

/// `lowest` <= normal . x <= `highest`, x in space and in the geometry's frame. Seen along z over the slab this is a
/// strip (a line for a plane that stands on a flat polygon) or all or nothing of the polygon's plane. Of the strip a
/// square is made around the polygon, so large that the polygon can't leave it on a shorter way than across the strip,
/// and that what is nearest to the polygon is in it.
std::optional<Shadow> stripShadow(const Eigen::Vector3d& normal, double offset, bool below_too, const View& view) {
  // x = M p + t lies in the plane n . p = d if M^-T n . x = d + M^-T n . t.
  const Eigen::Vector3d n = view.to_polygon.linear().inverse().transpose() * normal;
  const double d = offset + n.dot(view.to_polygon.translation());
  const Vec2 center = view.around.center(), across = n.head<2>();
  const double radius = view.around.diagonal().stableNorm() / 2, steepness = across.stableNorm();
  const double at_low = d - n.z() * view.slab.low - across.dot(center);
  const double at_high = d - n.z() * view.slab.high - across.dot(center);

  double side = 4 * radius;
  const double away = std::max(std::abs(at_low), std::abs(at_high)) / steepness;
  if (std::isfinite(away)) side += 2 * away;  // otherwise parallel: the plane is met all over, or nowhere
  const double rounding = mappingError(view.to_polygon, std::abs(offset) + center.stableNorm() + side) +
                          kMappingError * std::max(std::abs(view.slab.low), std::abs(view.slab.high));

  Ring ring = {{-side, -side}, {side, -side}, {side, side}, {-side, side}};
  ring = clip(ring, across, std::max(at_low, at_high) + rounding);
  if (!below_too) ring = clip(ring, -across, rounding - std::min(at_low, at_high));
  if (ring.empty()) return std::nullopt;
  for (Vec2& v : ring) v += center;
  return Shadow(tricover::Polygon({convexHull(ring)}, tricover::FillRule::NonZero), rounding);
}

}  // namespace

template <typename S>
std::optional<Shadow> makeHalfspaceShadow(const fcl::CollisionGeometry<S>& plane_or_halfspace, const View& view) {
  if (plane_or_halfspace.getNodeType() == fcl::GEOM_PLANE) {
    const auto& plane = static_cast<const fcl::Plane<S>&>(plane_or_halfspace);
    return stripShadow(plane.n.template cast<double>(), static_cast<double>(plane.d), false, view);
  }
  const auto& halfspace = static_cast<const fcl::Halfspace<S>&>(plane_or_halfspace);
  return stripShadow(halfspace.n.template cast<double>(), static_cast<double>(halfspace.d), true, view);
}

template std::optional<Shadow> makeHalfspaceShadow(const fcl::CollisionGeometry<float>&, const View&);
template std::optional<Shadow> makeHalfspaceShadow(const fcl::CollisionGeometry<double>&, const View&);

}  // namespace tricover_fcl
