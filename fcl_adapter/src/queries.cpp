// SPDX-License-Identifier: BSD-3-Clause
#include "queries.h"

#include "collide_polygons.h"
#include "unsupported.h"

namespace tricover_fcl {

template <typename S>
std::size_t collideGeometries(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                              const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                              const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result) {
  if (!isPolygon(o1) || !isPolygon(o2)) throwUnsupported("collide", o1, o2);
  return collidePolygons(o1, tf1, o2, tf2, request, result);
}

template <typename S>
S distanceOfGeometries(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>&,
                       const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>&, const fcl::DistanceRequest<S>&,
                       fcl::DistanceResult<S>&) {
  throwUnsupported("distance", o1, o2);
}

template <typename S>
S advanceGeometries(const fcl::CollisionGeometry<S>& o1, const fcl::MotionBase<S>&, const fcl::CollisionGeometry<S>& o2,
                    const fcl::MotionBase<S>&, const fcl::ContinuousCollisionRequest<S>&,
                    fcl::ContinuousCollisionResult<S>&) {
  throwUnsupported("conservative advancement", o1, o2);
}

#define TRICOVER_INSTANTIATE(S)                                                                       \
  template std::size_t collideGeometries(const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&, \
                                         const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&, \
                                         const fcl::CollisionRequest<S>&, fcl::CollisionResult<S>&);  \
  template S distanceOfGeometries(const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&,        \
                                  const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&,        \
                                  const fcl::DistanceRequest<S>&, fcl::DistanceResult<S>&);           \
  template S advanceGeometries(const fcl::CollisionGeometry<S>&, const fcl::MotionBase<S>&,           \
                               const fcl::CollisionGeometry<S>&, const fcl::MotionBase<S>&,           \
                               const fcl::ContinuousCollisionRequest<S>&, fcl::ContinuousCollisionResult<S>&);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
