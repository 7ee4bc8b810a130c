// SPDX-License-Identifier: BSD-3-Clause
#include "polygons/distance_polygons.h"

#include <cmath>
#include <limits>

#include "polygons/disc_pair.h"
#include "polygons/polygon_pair.h"
#include "shape/fcl_results.h"

namespace tricover_fcl {
namespace {

/// Planar points of a and b, each at a height of its own shape: as near to each other as the heights allow.
template <typename S>
struct PointsInSpace {
  PointsInSpace(const PolygonPair<S>& pair, bool heights_meet, const tricover::DistanceResult& found) {
    const Heights a = pair.heights_a, b = pair.heights_b;
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

/// Of two discs, if these are plainly apart: where they aren't, more is to be told.
template <typename S>
bool updateApart(const PolygonShape<S>& a, const fcl::Transform3<S>& tf1, const PolygonShape<S>& b,
                 const fcl::Transform3<S>& tf2, const tricover::DistanceOptions& options,
                 fcl::DistanceResult<S>& result) {
  if (!(options.relative_error >= 0 && options.absolute_error >= 0 && result.min_distance > 0)) return false;
  const DiscPair<S> pair(a, tf1, b, tf2);
  const std::optional<double> distance = pair.distanceBeyond(options.margin);
  if (!distance) return false;
  const tricover::Vec2 towards = pair.between / *distance;
  const auto nearest = [&, z = pair.middleHeight()](const fcl::Transform3<S>& pose, double way) {
    const auto center = [&](int axis) { return static_cast<double>(pose.matrix()(axis, 3)); };
    return fcl::Vector3<double>(center(0) + way * towards.x(), center(1) + way * towards.y(), z);
  };
  updateDistance(a, b, *distance - options.margin, nearest(tf1, a.options().margin), nearest(tf2, -b.options().margin),
                 0, 0, result);
  return true;
}

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
  if (DiscPair<S>::areDiscs(shape_a, shape_b) && updateApart(shape_a, tf1, shape_b, tf2, options, result))
    return result.min_distance;
  const PolygonPair<S> pair(shape_a, tf1, shape_b, tf2);
  const double apart = pair.heightsMeet() ? 0 : gap(pair.heights_a, pair.heights_b);
  const auto limit = static_cast<double>(result.min_distance);
  if (apart >= limit) return result.min_distance;

  auto found = pair.distanceWithin(limit, options);
  if (!found) return result.min_distance;
  moveByMargins(pair, *found);
  if (found->distance == 0 && apart == 0) {
    requireContactsIfSigned(o1, o2, request);
    // FCL takes a depth below the smallest normal number for none, and asserts that there is one.
    *found =
        overlapOf(pair, request.enable_signed_distance, static_cast<double>(std::numeric_limits<S>::min()), *found);
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
