// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/collision_request.h>
#include <fcl/narrowphase/collision_result.h>
#include <fcl/narrowphase/continuous_collision_result.h>
#include <fcl/narrowphase/distance_request.h>
#include <fcl/narrowphase/distance_result.h>

#include <cstddef>
#include <optional>

#include "shape/plane.h"
#include "tricover/distance.h"

/// How planar answers are written into FCL's results, by FCL's rules.
namespace tricover_fcl {

/// What a hit of the pair would leave: contacts if both are occupied, cost sources if asked for and neither is free.
struct Wanted {
  bool contacts, costs;
};

template <typename S>
Wanted wanted(const fcl::CollisionGeometry<S>& o1, const fcl::CollisionGeometry<S>& o2,
              const fcl::CollisionRequest<S>& request) {
  return {o1.isOccupied() && o2.isOccupied(), request.enable_cost && !o1.isFree() && !o2.isFree()};
}

/// How many contacts may be added.
template <typename S>
std::size_t room(const fcl::CollisionRequest<S>& request, const fcl::CollisionResult<S>& result) {
  return request.num_max_contacts > result.numContacts() ? request.num_max_contacts - result.numContacts() : 0;
}

/// What distances may be wrong by.
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
                             const fcl::DistanceRequest<S>& request);

/// A hit without details.
template <typename S>
void addContact(const fcl::CollisionGeometry<S>& o1, const fcl::CollisionGeometry<S>& o2,
                fcl::CollisionResult<S>& result);

/// What o1 and o2 share, in the plane.
struct PlanarContact {
  tricover::Vec2 point;
  tricover::Vec2 normal;  ///< from o1 to o2
  double depth;
  std::ptrdiff_t edge1, edge2;  ///< -1: none
};

template <typename S>
void addContact(const fcl::CollisionGeometry<S>& o1, const fcl::CollisionGeometry<S>& o2, const Plane& plane,
                const PlanarContact& contact, fcl::CollisionResult<S>& result);

/// A cost source in the overlap of the world's boxes: 1 thick where that has no thickness, because it would cost
/// nothing.
template <typename S>
void addCost(const fcl::CollisionGeometry<S>& o1, const fcl::CollisionGeometry<S>& o2, Eigen::AlignedBox3d overlap,
             const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result);

/// Keeps the smaller distance, as FCL's own rows do; points in the world, edges -1 for none. A distance that S can't
/// hold is no smaller one; one that is too small for S, but not 0, doesn't become 0.
template <typename S>
void updateDistance(const fcl::CollisionGeometry<S>& o1, const fcl::CollisionGeometry<S>& o2, double distance,
                    const fcl::Vector3<double>& point1, const fcl::Vector3<double>& point2, std::ptrdiff_t edge1,
                    std::ptrdiff_t edge2, fcl::DistanceResult<S>& result);

/// Leaves the result as it is, because the pair is no nearer. Where nothing was ever found, FCL leaves the nearest
/// points uninitialised: they become NaN. Returns the result's distance.
template <typename S>
S keepDistance(fcl::DistanceResult<S>& result);

/// The first contact, or none. Rounded to S it is no later.
template <typename S>
S reportImpact(std::optional<double> time, fcl::ContinuousCollisionResult<S>& result);

}  // namespace tricover_fcl
