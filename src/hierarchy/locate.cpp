// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/locate.h"

#include <algorithm>
#include <cmath>

#include "hierarchy/hierarchy.h"
#include "hierarchy/inclusion.h"
#include "hierarchy/simd.h"
#include "numbers/errors.h"
#include "numbers/rounding.h"
#include "polygon/cache_access.h"

namespace tricover {
namespace {

/// Null until the queries so far have cost as much as a tree (ski-rental).
const detail::Hierarchy* hierarchyInTime(const detail::PolygonData& polygon) {
  const detail::Hierarchy* built = detail::hierarchyIfBuilt(polygon);
  if (built != nullptr) return built;
  const bool is_due = polygon.hierarchy_rental.isDue(polygon.path.size(), detail::hierarchyPrice(polygon));
  return is_due ? &detail::hierarchyOf(polygon) : nullptr;
}

/// Whether the bounding disc, which answers sooner than a certificate, tells where a point is.
bool isOutsideDisc(const detail::PolygonData& polygon, const Vec2& point) {
  return detail::outsideBoundingDisc(polygon, detail::IncludedPoint::ofFrame(point).approx);
}

Location locateInDisc(const detail::PolygonData& polygon, const detail::Hierarchy* tree, const Vec2& point) {
  return detail::locateInDisc(polygon, tree, detail::IncludedPoint::ofFrame(point));
}

/// A lower bound of the distance from the edges, looked for within `most`.
double clearanceOf(const detail::PolygonData& polygon, const detail::Hierarchy& tree, const Vec2& point, double most) {
  if (!polygon.fitsUnit()) return 0;
  const Vec2 at = polygon.inUnits(point);
  const detail::Place place{at.x(), at.y(), 2 * detail::kUnitRoundoff * (std::abs(at.x()) + std::abs(at.y()))};
  return detail::clearanceAt(tree, place, most * polygon.inverse_unit) * polygon.unit;
}

/// By the certificate, which is renewed where that may pay. Not inlined, because most queries of a back-off don't come
/// here.
[[gnu::noinline]] Location locateByCertificate(const detail::PolygonData& data, const Vec2& point,
                                               detail::PointCertificate& cache) {
  const auto keep = [&](Location location, bool was_sought, double clearance) {
    cache = {{clearance, 0, was_sought, cache.back_off}, location, data.id, {point.x(), point.y()}};
    return location;
  };
  // The last query of a back-off keeps the point: the next one then knows how far the point has come.
  if (cache.back_off.isOn()) {
    cache.back_off.left = 0;
    return keep(locateInDisc(data, hierarchyInTime(data), point), false, 0);
  }
  const Vec2 way = point - Vec2(cache.point[0], cache.point[1]);
  // At least as long: no squares, which might be 0.
  const double moved = (std::abs(way.x()) + std::abs(way.y())) * (1 + 4 * detail::kUnitRoundoff);
  const bool known = cache.polygon_id == data.id;
  if (known && (moved < cache.clearance || moved == 0)) {
    ++cache.uses;
    return cache.location;
  }
  const detail::Hierarchy* tree = hierarchyInTime(data);
  // A point looks ahead for half as many steps as a pair, and up to twice as far: its clearance costs little.
  const double ahead = known ? cache.lookahead(0.5 * moved, 2 * data.radius) : 0;
  const bool renews = cache.isWorthRenewing(known, ahead > 0);
  const Location location = locateInDisc(data, tree, point);
  const bool seeks = renews && tree != nullptr && location != Location::Boundary;
  return keep(location, seeks, seeks ? clearanceOf(data, *tree, point, ahead) : 0);
}

}  // namespace

Location locate(const Polygon& polygon, const Vec2& point) {
  detail::requireFinite(point, "point");
  const detail::PolygonData& data = polygon.data();
  return isOutsideDisc(data, point) ? detail::includeFarAway(data).location
                                    : locateInDisc(data, hierarchyInTime(data), point);
}

Location locate(const Polygon& polygon, const Vec2& point, PointCache& caller_cache) {
  detail::PointCertificate& cache = detail::contentsOf(caller_cache);
  detail::requireFinite(point, "point");
  const detail::PolygonData& data = polygon.data();
  if (isOutsideDisc(data, point)) return detail::includeFarAway(data).location;
  if (cache.back_off.left <= 1) return locateByCertificate(data, point, cache);
  --cache.back_off.left;
  return locateInDisc(data, hierarchyInTime(data), point);
}

}  // namespace tricover
