// SPDX-License-Identifier: BSD-3-Clause
#include "shape/fcl_results.h"

#include <limits>

#include "shape/errors.h"
#include "shape/motion_in_plane.h"

namespace tricover_fcl {

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

template <typename S>
void addContact(const fcl::CollisionGeometry<S>& o1, const fcl::CollisionGeometry<S>& o2,
                fcl::CollisionResult<S>& result) {
  // Zeros, because FCL's shorter constructor leaves these fields uninitialised.
  result.addContact(fcl::Contact<S>(&o1, &o2, fcl::Contact<S>::NONE, fcl::Contact<S>::NONE, fcl::Vector3<S>::Zero(),
                                    fcl::Vector3<S>::Zero(), S(0)));
}

template <typename S>
void addContact(const fcl::CollisionGeometry<S>& o1, const fcl::CollisionGeometry<S>& o2, const Plane& plane,
                const PlanarContact& contact, fcl::CollisionResult<S>& result) {
  const fcl::Vector3<double> point = plane * fcl::Vector3<double>(contact.point.x(), contact.point.y(), 0);
  const fcl::Vector3<double> normal = plane.linear() * fcl::Vector3<double>(contact.normal.x(), contact.normal.y(), 0);
  fcl::Contact<S> added(&o1, &o2, fcl::Contact<S>::NONE, fcl::Contact<S>::NONE, point.cast<S>(), normal.cast<S>(),
                        static_cast<S>(contact.depth));
  added.b1 = contact.edge1;  // the constructor takes ints
  added.b2 = contact.edge2;
  result.addContact(added);
}

template <typename S>
void addCost(const fcl::CollisionGeometry<S>& o1, const fcl::CollisionGeometry<S>& o2, Eigen::AlignedBox3d overlap,
             const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result) {
  if (!(overlap.max().z() > overlap.min().z())) {
    overlap.min().z() -= 0.5;
    overlap.max().z() += 0.5;
  }
  result.addCostSource(
      fcl::CostSource<S>(overlap.min().cast<S>(), overlap.max().cast<S>(), o1.cost_density * o2.cost_density),
      request.num_max_cost_sources);
}

template <typename S>
S keepDistance(fcl::DistanceResult<S>& result) {
  if (result.o1 == nullptr && result.o2 == nullptr)
    result.nearest_points[0] = result.nearest_points[1] =
        fcl::Vector3<S>::Constant(std::numeric_limits<S>::quiet_NaN());
  return result.min_distance;
}

template <typename S>
void updateDistance(const fcl::CollisionGeometry<S>& o1, const fcl::CollisionGeometry<S>& o2, double distance,
                    const fcl::Vector3<double>& point1, const fcl::Vector3<double>& point2, std::ptrdiff_t edge1,
                    std::ptrdiff_t edge2, fcl::DistanceResult<S>& result) {
  S rounded = static_cast<S>(distance);
  if (rounded == 0 && distance > 0) rounded = std::numeric_limits<S>::denorm_min();
  if (!(distance < static_cast<double>(std::numeric_limits<S>::max())) || !(rounded < result.min_distance)) {
    keepDistance(result);
    return;
  }
  result.update(rounded, &o1, &o2, fcl::DistanceResult<S>::NONE, fcl::DistanceResult<S>::NONE, point1.cast<S>(),
                point2.cast<S>());
  result.b1 = edge1;  // update takes ints
  result.b2 = edge2;
}

template <typename S>
S reportImpact(std::optional<double> time, fcl::ContinuousCollisionResult<S>& result) {
  result.is_collide = time.has_value();
  result.time_of_contact = roundDown<S>(time.value_or(1));
  return result.time_of_contact;
}

#define TRICOVER_INSTANTIATE(S)                                                                                  \
  template void requireContactsIfSigned(const fcl::CollisionGeometry<S>&, const fcl::CollisionGeometry<S>&,      \
                                        const fcl::DistanceRequest<S>&);                                         \
  template void addContact(const fcl::CollisionGeometry<S>&, const fcl::CollisionGeometry<S>&,                   \
                           fcl::CollisionResult<S>&);                                                            \
  template void addContact(const fcl::CollisionGeometry<S>&, const fcl::CollisionGeometry<S>&, const Plane&,     \
                           const PlanarContact&, fcl::CollisionResult<S>&);                                      \
  template void addCost(const fcl::CollisionGeometry<S>&, const fcl::CollisionGeometry<S>&, Eigen::AlignedBox3d, \
                        const fcl::CollisionRequest<S>&, fcl::CollisionResult<S>&);                              \
  template void updateDistance(const fcl::CollisionGeometry<S>&, const fcl::CollisionGeometry<S>&, double,       \
                               const fcl::Vector3<double>&, const fcl::Vector3<double>&, std::ptrdiff_t,         \
                               std::ptrdiff_t, fcl::DistanceResult<S>&);                                         \
  template S keepDistance(fcl::DistanceResult<S>&);                                                              \
  template S reportImpact(std::optional<double>, fcl::ContinuousCollisionResult<S>&);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
