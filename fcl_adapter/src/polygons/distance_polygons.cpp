// SPDX-License-Identifier: BSD-3-Clause
#include "polygons/distance_polygons.h"

#include <cmath>
#include <limits>

#include "polygons/polygon_pair.h"
#include "shape/crossing.h"
#include "shape/fcl_results.h"
#include "shape/nearest_points.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"

namespace tricover_fcl {
namespace {

/// Planar points of a and b, each at a height of its own shape: as near to each other as the heights allow.
template <typename S>
struct NearestPoints {
  NearestPoints(const PolygonPair<S>& pair, bool heights_meet, const tricover::Vec2& point_a,
                const tricover::Vec2& point_b) {
    const Heights a = pair.heightsA(), b = pair.heightsB();
    const bool a_below = !heights_meet && isBelow(a.high, b.low), a_above = !heights_meet && !a_below;
    const double middle = sharedHeights(a, b).middle();
    on_a << point_a, a_below ? a.high.rounded() : a_above ? a.low.rounded() : middle;
    on_b << point_b, a_below ? b.low.rounded() : a_above ? b.high.rounded() : middle;
  }

  fcl::Vector3<double> on_a, on_b;
};

/// What FCL reports of regions that share a point.
template <typename S>
void updateOverlap(const PolygonPair<S>& pair, bool is_signed, const tricover::DistanceResult& common,
                   fcl::DistanceResult<S>& result) {
  const tricover::Polygon &a = pair.a(), &b = pair.b();
  const auto report = [&](double distance, const auto& from) {
    const NearestPoints<S> points(pair, true, from.point_a, from.point_b);
    updateDistance(pair.shape_a, pair.shape_b, distance, points.on_a, points.on_b, from.edge_a, from.edge_b, result);
  };
  // FCL takes a depth below the smallest normal number for none, and asserts that there is one.
  const auto isDepth = [](double depth) { return depth > static_cast<double>(std::numeric_limits<S>::min()); };
  if (is_signed) {
    const auto penetration = tricover::penetration(a, pair.pose_a.pose, b, pair.pose_b.pose);
    if (penetration && isDepth(penetration->depth)) return report(-penetration->depth, *penetration);
  } else {
    // Edges that cross and rings that lie inside without meeting an edge go on overlapping when moved a little.
    // Contacts are needed of the others only, which mostly touch.
    const bool holds_ring = common.edge_a < 0 || common.edge_b < 0;
    if (holds_ring || crossDeeply(a, pair.pose_a.pose, common.edge_a, b, pair.pose_b.pose, common.edge_b, 0))
      return report(-1, common);
    const auto deepest = tricover::contacts(a, pair.pose_a.pose, b, pair.pose_b.pose, 1);
    if (!deepest.empty() && isDepth(deepest.front().depth)) return report(-1, common);
  }
  report(0, common);
}

}  // namespace

template <typename S>
S distanceOfPolygons(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                     const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                     const fcl::DistanceRequest<S>& request, fcl::DistanceResult<S>& result) {
  if (request.isSatisfied(result)) return result.min_distance;
  const PolygonPair<S> pair(o1, tf1, o2, tf2);

  // Nothing above the distance that the result already holds is of interest, and no pair is nearer than its heights.
  tricover::DistanceOptions options;
  options.relative_error = static_cast<double>(request.rel_err);
  options.absolute_error = static_cast<double>(request.abs_err);
  options.limit = static_cast<double>(result.min_distance);
  options.margin = pair.shape_a.options().margin + pair.shape_b.options().margin;
  const double apart = pair.heightsMeet() ? 0 : gap(pair.heightsA(), pair.heightsB());
  if (apart >= options.limit) return result.min_distance;

  const auto distance = [&](auto&... cache) {
    return tricover::distance(pair.a(), pair.pose_a.pose, pair.b(), pair.pose_b.pose, cache..., options);
  };
  tricover::DistanceResult planar = pair.template remembering<tricover::DistanceCache>(tf1, tf2, distance);
  if (options.margin > 0) moveByMargins(planar, pair.shape_a.options().margin, pair.shape_b.options().margin);
  if (planar.distance == 0 && apart == 0) {
    requireContactsIfSigned(o1, o2, request);
    updateOverlap(pair, request.enable_signed_distance, planar, result);
  } else if (planar.distance <= options.limit) {
    const NearestPoints<S> points(pair, apart == 0, planar.point_a, planar.point_b);
    const double distance_in_space = apart == 0 ? planar.distance : std::hypot(planar.distance, apart);
    updateDistance(o1, o2, distance_in_space, points.on_a, points.on_b, planar.edge_a, planar.edge_b, result);
  }
  return result.min_distance;
}

#define TRICOVER_INSTANTIATE(S)                                                              \
  template S distanceOfPolygons(const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&, \
                                const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&, \
                                const fcl::DistanceRequest<S>&, fcl::DistanceResult<S>&);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
