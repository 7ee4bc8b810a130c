// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>

#include "polygons/polygon_pair.h"
#include "polygons/polygons.h"
#include "shape/fcl_results.h"

namespace tricover_fcl {
namespace {

/// Planar points of a and b, each at a height of its own shape: as near to each other as the heights allow.
template <typename S>
struct PointsInSpace {
  PointsInSpace(const PolygonPair<S>& pair, bool heights_meet, const tricover::DistanceResult& found) {
    const Heights a = pair.heightsOfA(), b = pair.heightsOfB();
    double z_a, z_b;
    if (heights_meet) {
      z_a = z_b = sharedHeights(a, b).middle();
    } else {
      const bool below = isBelow(a.high, b.low);
      z_a = (below ? a.high : a.low).rounded();
      z_b = (below ? b.low : b.high).rounded();
    }
    on_a = {found.point_a.x(), found.point_a.y(), z_a};
    on_b = {found.point_b.x(), found.point_b.y(), z_b};
  }

  fcl::Vector3<double> on_a, on_b;
};

}  // namespace

template <typename S>
S distanceOfPolygons(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                     const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                     const fcl::DistanceRequest<S>& request, fcl::DistanceResult<S>& result) {
  if (request.isSatisfied(result)) return result.min_distance;
  const auto &shape_a = static_cast<const PolygonShape<S>&>(o1), &shape_b = static_cast<const PolygonShape<S>&>(o2);

  // Nothing above the distance that the result already holds is of interest, and no pair is nearer than its heights.
  tricover::DistanceOptions options = errorsOf(request);
  options.margin = shape_a.options().margin + shape_b.options().margin;
  const PolygonPair<S> pair(shape_a, tf1, shape_b, tf2);
  const double apart = pair.heightsMeet() ? 0 : gap(pair.heightsOfA(), pair.heightsOfB());
  const auto limit = static_cast<double>(result.min_distance);
  if (apart >= limit) return keepDistance(result);

  auto found = pair.distanceWithin(limit, options);
  if (!found) return keepDistance(result);
  moveByMargins(pair, *found);
  if (found->distance == 0 && apart == 0) {
    requireContactsIfSigned(o1, o2, request);
    // FCL takes a depth below the smallest normal number for none, and asserts that there is one.
    const auto least = static_cast<double>(std::numeric_limits<S>::min());
    *found = overlapOf(pair, request.enable_signed_distance, false, 0, least, *found);
  }
  const PointsInSpace<S> points(pair, apart == 0, *found);
  const double distance = apart == 0 ? found->distance : std::hypot(found->distance, apart);
  updateDistance(o1, o2, distance, points.on_a, points.on_b, found->edge_a, found->edge_b, result);
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
