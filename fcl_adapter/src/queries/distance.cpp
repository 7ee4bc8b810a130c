// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "queries/planar_pair.h"
#include "queries/queries.h"
#include "shape/errors.h"

namespace tricover_fcl {
namespace {

/// FCL calls collide about a negative distance, and insists on a depth that is a normal number.
template <typename S>
constexpr double kLeastDepth = static_cast<double>(std::numeric_limits<S>::min());

/// The errors that a distance may have.
template <typename S>
tricover::DistanceOptions errorsOf(const fcl::DistanceRequest<S>& request) {
  tricover::DistanceOptions options;
  options.relative_error = static_cast<double>(request.rel_err);
  options.absolute_error = static_cast<double>(request.abs_err);
  return options;
}

/// FCL's dispatcher asks collide for a contact where a signed distance is negative (under GST_INDEP, and of meshes and
/// octrees), and aborts where there is none, as of geometries that aren't occupied: throws std::logic_error then.
template <typename S>
void requireContactsIfSigned(const fcl::CollisionGeometry<S>& o1, const fcl::CollisionGeometry<S>& o2,
                             const fcl::DistanceRequest<S>& request) {
  if (!request.enable_signed_distance || (o1.isOccupied() && o2.isOccupied())) return;
  if (request.gjk_solver_type == fcl::GST_INDEP || o1.getObjectType() != fcl::OT_GEOM ||
      o2.getObjectType() != fcl::OT_GEOM) {
    refuseQuestion("enable_signed_distance",
                   "under GST_INDEP, and of meshes and octrees, FCL needs a contact, and geometries have none that are "
                   "not occupied",
                   "clear it, or raise cost_density to threshold_occupied");
  }
}

/// Leaves the result as it is, because the pair is no nearer. Where nothing was ever found, FCL leaves the nearest
/// points uninitialised: they become NaN. Returns the result's distance.
template <typename S>
S keepDistance(fcl::DistanceResult<S>& result) {
  if (result.o1 == nullptr && result.o2 == nullptr)
    result.nearest_points[0] = result.nearest_points[1] =
        fcl::Vector3<S>::Constant(std::numeric_limits<S>::quiet_NaN());
  return result.min_distance;
}

/// Points in the world.
struct Span {
  double distance;
  Eigen::Vector3d on_a, on_b;
};

/// Planar points of a and b, each at a height of its own geometry: as near to each other as the heights allow. A prism
/// around parts above and below the polygon shares its heights.
Span spanOf(const PlanarPair& pair, const tricover::DistanceResult& found) {
  const Heights &a = pair.a.heights, &b = pair.b.heights;
  const bool is_beside = pair.apart > 0 && gap(a, b) > 0, is_b_below = is_beside && isBelow(b.high(), a.low());
  const double z_a = !is_beside ? pair.middle() : (is_b_below ? a.low() : a.high()).rounded();
  const double z_b = !is_beside ? z_a : (is_b_below ? b.high() : b.low()).rounded();
  const bool is_one = pair.apart > 0 && found.distance == 0;
  return {pair.apart > 0 ? std::hypot(found.distance, pair.apart) : found.distance, pair.inWorld(found.point_a, z_a),
          pair.inWorld(is_one ? found.point_a : found.point_b, z_b)};
}

/// The distance of a polygon from a geometry that covers all of its plane.
Span liftOf(const PlanarPair& pair, const Shadow::Lift& lift, bool is_signed) {
  const bool first = pair.other == &pair.b;
  const Eigen::Vector3d at = pair.inWorld((first ? pair.a : pair.b).polygon->coveringOrigin(), pair.middle());
  Span span{is_signed ? -lift.depth : -1, at, at};
  if (std::isfinite(lift.depth)) (first ? span.on_b : span.on_a) -= pair.frame->linear() * (lift.depth * lift.normal);
  return span;
}

}  // namespace

template <typename S>
S distanceOfGeometries(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                       const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                       const fcl::DistanceRequest<S>& request, fcl::DistanceResult<S>& result) {
  const bool first = isPolygon(o1), second = isPolygon(o2);
  if (!first && !second) {
    warnAsFcl("distance", o1, o2);
    return std::numeric_limits<S>::max();
  }
  if (request.isSatisfied(result)) return result.min_distance;
  PlanarPair pair;
  if (first && second) {
    placePolygons(pair, static_cast<const PolygonShape<S>&>(o1), tf1, static_cast<const PolygonShape<S>&>(o2), tf2, 0);
  } else {
    const MixedGeometries<S> both{o1, tf1, o2, tf2};
    placeMixed(pair, "distance", both, false);
    // Above or below the polygon's heights it is measured as a prism, between its lowest and its highest point.
    if (pair.apart > 0 && placeShadow(pair, both, true, false))
      pair.apart = std::max(gap(pair.a.heights, pair.b.heights), std::numeric_limits<double>::denorm_min());
  }
  // Nothing above the distance that the result already holds is of interest, and no pair is nearer than its heights.
  const auto limit = static_cast<double>(result.min_distance);
  if (pair.apart >= limit) return keepDistance(result);
  auto found = pair.distanceWithin(limit, errorsOf(request));
  if (!found) return keepDistance(result);

  moveByMargins(pair, *found);
  const bool is_signed = request.enable_signed_distance, meets = found->distance == 0 && pair.apart == 0;
  const auto* const lift = pair.shadow && pair.shadow->lift ? &*pair.shadow->lift : nullptr;
  if (meets && lift == nullptr) *found = overlapOf(pair, is_signed, kLeastDepth<S>, *found);
  const bool is_covered =
      meets && lift != nullptr && lift->depth > std::max(pair.shadow->outlineError(), kLeastDepth<S>);
  const Span span = is_covered ? liftOf(pair, *lift, is_signed) : spanOf(pair, *found);
  if (span.distance < 0) requireContactsIfSigned(o1, o2, request);

  // The smaller distance stays, as in FCL's own rows. A distance that S can't hold is no smaller one; one that is too
  // small for S, but not 0, doesn't become 0.
  S rounded = static_cast<S>(span.distance);
  if (rounded == 0 && span.distance > 0) rounded = std::numeric_limits<S>::denorm_min();
  if (!(span.distance < static_cast<double>(std::numeric_limits<S>::max())) || !(rounded < result.min_distance))
    return keepDistance(result);
  constexpr int kNone = fcl::DistanceResult<S>::NONE;
  result.update(rounded, &o1, &o2, kNone, kNone, span.on_a.template cast<S>(), span.on_b.template cast<S>());
  result.b1 = pair.idOf(pair.a, found->edge_a);  // update takes ints
  result.b2 = pair.idOf(pair.b, found->edge_b);
  return result.min_distance;
}

#define TRICOVER_INSTANTIATE(S)                                                                \
  template S distanceOfGeometries(const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&, \
                                  const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&, \
                                  const fcl::DistanceRequest<S>&, fcl::DistanceResult<S>&);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
