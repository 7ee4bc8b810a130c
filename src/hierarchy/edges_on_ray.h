// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "hierarchy/simd.h"
#include "polygon/edge_walk.h"

namespace tricover::detail {

/// Calls visit(edge), a position, until it returns false, for every edge that a ray may meet, the first roughly first;
/// without a ray (null) for every edge. The visit may shorten the ray.
template <typename Visit>
void forEachEdgeOn(const PolygonData& polygon, const Ray* ray, Visit&& visit) {
  if (ray == nullptr) return forEachEdge(polygon, visit);
  const auto call = [](void* context, std::uint32_t edge) {
    return (*static_cast<std::remove_reference_t<Visit>*>(context))(edge);
  };
  visitEdgesOnRay(hierarchyOf(polygon), *ray, call, &visit);
}

/// The same for every edge that may come within `reach` of the segment between two points, in units. Where these are
/// wrong, in any direction, the reach has to hold that, too.
template <typename Visit>
void forEachEdgeNear(const PolygonData& polygon, const Vec2& from, const Vec2& to, double reach, Visit visit) {
  const Vec2 way = to - from;
  const double length = way.norm(), rounding = 0x1p-46 * (from.lpNorm<1>() + length + 4);
  Ray ray{from.x(), from.y(), 1, 0, reach + rounding, length};
  if (length > 0x1p-400) ray.dx = way.x() / length, ray.dy = way.y() / length;
  const bool is_known = polygon.fitsUnit() && ray.error < 0x1p1000 && length < 0x1p1000;
  forEachEdgeOn(polygon, is_known ? &ray : nullptr, visit);
}

}  // namespace tricover::detail
