// SPDX-License-Identifier: BSD-3-Clause
#include <fcl/geometry/shape/halfspace.h>
#include <fcl/geometry/shape/plane.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "shadow/shadow.h"
#include "shape/convex_hull.h"
#include "shape/errors.h"

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

/// The plane normal . x = offset of the geometry's frame, or the half-space below it. Seen along z over the slab it is
/// a strip (a line for a plane that stands on a flat polygon) or a half-plane. Of that a square is made around the
/// polygon, so large that the polygon can't leave it on a shorter way than across the edge, and that what is nearest to
/// the polygon is in it. What is parallel to the polygon, as far as rounding can tell, is met all over, or nowhere. So
/// is what doesn't stand upright by a polygon at all heights, and no way parts these.
std::optional<Shadow> shadowOf(const char* name, const Eigen::Vector3d& normal, double offset, bool below_too,
                               const View& view) {
  if (!(normal.allFinite() && std::isfinite(offset))) refuse(name, "its normal or offset is not finite");
  // x = M p + t lies in the plane n . p = d if M^-T n . x = d + M^-T n . t.
  const Eigen::Vector3d n = view.to_polygon.linear().inverse().transpose() * normal;
  const double d = offset + n.dot(view.to_polygon.translation());
  const Vec2 center = view.around.center();
  const double radius = view.around.diagonal().stableNorm() / 2, steepness = n.head<2>().stableNorm();
  const bool everywhere = view.slab.isAll() && std::abs(n.z()) > kMappingError;
  const Slab slab = view.slab.isAll() ? Slab{0, 0} : view.slab;
  const bool parallel = steepness <= kMappingError || everywhere;
  const Vec2 across = parallel ? Vec2(Vec2::Zero()) : Vec2(n.head<2>());
  const double at_low = d - n.z() * slab.low - across.dot(center);
  const double at_high = d - n.z() * slab.high - across.dot(center);
  const double all = everywhere ? std::numeric_limits<double>::infinity() : 0;
  const double first = std::min(at_low, at_high) - all, last = std::max(at_low, at_high) + all;

  const double side = 4 * radius + (parallel ? 0 : 2 * std::max(std::abs(first), std::abs(last)) / steepness);
  const double rounding = mappingError(
      view.to_polygon, std::abs(offset) + center.stableNorm() + side + std::abs(slab.low) + std::abs(slab.high));
  Ring ring = {{-side, -side}, {side, -side}, {side, side}, {-side, side}};
  ring = clip(ring, across, last + rounding);
  if (!below_too) ring = clip(ring, -across, rounding - first);
  if (ring.empty()) return std::nullopt;
  for (Vec2& v : ring) v += center;
  // A tilted one is at all heights.
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Slab heights{-kInfinity, kInfinity};
  if (steepness <= kMappingError) {
    const double height = d / n.z();
    heights = {below_too && n.z() > 0 ? -kInfinity : height, below_too && n.z() < 0 ? kInfinity : height};
  }
  Shadow shadow = shadowOf(outlineOf(convexHull(ring)), rounding, heights, view);
  shadow.is_surface = !below_too;
  if (parallel) {
    const bool up = below_too || last <= -first;  // the way of the polygon, along n
    shadow.lift = {(up ? -1 : 1) * n.normalized(), std::max(up ? last : -first, 0.0)};
  }
  return shadow;
}

}  // namespace

template <typename S>
std::optional<Shadow> makeHalfspaceShadow(const fcl::CollisionGeometry<S>& plane_or_halfspace, const View& view) {
  if (plane_or_halfspace.getNodeType() == fcl::GEOM_PLANE) {
    const auto& plane = static_cast<const fcl::Plane<S>&>(plane_or_halfspace);
    return shadowOf("fcl::Plane", plane.n.template cast<double>(), static_cast<double>(plane.d), false, view);
  }
  const auto& halfspace = static_cast<const fcl::Halfspace<S>&>(plane_or_halfspace);
  return shadowOf("fcl::Halfspace", halfspace.n.template cast<double>(), static_cast<double>(halfspace.d), true, view);
}

template std::optional<Shadow> makeHalfspaceShadow(const fcl::CollisionGeometry<float>&, const View&);
template std::optional<Shadow> makeHalfspaceShadow(const fcl::CollisionGeometry<double>&, const View&);

}  // namespace tricover_fcl
