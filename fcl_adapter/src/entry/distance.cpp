// SPDX-License-Identifier: BSD-3-Clause
#include "tricover_fcl/distance.h"

#include <fcl/broadphase/default_broadphase_callbacks.h>

#include "queries/queries.h"
#include "shape/is_polygon.h"

// In float_distance.cpp.
extern template float fcl::distance(const fcl::CollisionGeometry<float>*, const fcl::Transform3<float>&,
                                    const fcl::CollisionGeometry<float>*, const fcl::Transform3<float>&,
                                    const fcl::DistanceRequest<float>&, fcl::DistanceResult<float>&);

namespace tricover_fcl {

template <typename S>
S distance(const fcl::CollisionGeometry<S>* o1, const fcl::Transform3<S>& tf1, const fcl::CollisionGeometry<S>* o2,
           const fcl::Transform3<S>& tf2, const fcl::DistanceRequest<S>& request, fcl::DistanceResult<S>& result) {
  if (isPolygon(*o1) || isPolygon(*o2)) return distanceOfGeometries(*o1, tf1, *o2, tf2, request, result);
  return fcl::distance(o1, tf1, o2, tf2, request, result);
}

template <typename S>
S distance(const fcl::CollisionObject<S>* o1, const fcl::CollisionObject<S>* o2, const fcl::DistanceRequest<S>& request,
           fcl::DistanceResult<S>& result) {
  return tricover_fcl::distance(o1->collisionGeometry().get(), o1->getTransform(), o2->collisionGeometry().get(),
                                o2->getTransform(), request, result);
}

template <typename S>
bool defaultDistanceFunction(fcl::CollisionObject<S>* o1, fcl::CollisionObject<S>* o2, void* data, S& distance) {
  auto& query = *static_cast<fcl::DefaultDistanceData<S>*>(data);
  if (!query.done) tricover_fcl::distance(o1, o2, query.request, query.result);
  distance = query.result.min_distance;
  return query.done || distance <= 0;
}

#define TRICOVER_INSTANTIATE(S)                                                                                       \
  template S distance(const fcl::CollisionGeometry<S>*, const fcl::Transform3<S>&, const fcl::CollisionGeometry<S>*,  \
                      const fcl::Transform3<S>&, const fcl::DistanceRequest<S>&, fcl::DistanceResult<S>&);            \
  template S distance(const fcl::CollisionObject<S>*, const fcl::CollisionObject<S>*, const fcl::DistanceRequest<S>&, \
                      fcl::DistanceResult<S>&);                                                                       \
  template bool defaultDistanceFunction(fcl::CollisionObject<S>*, fcl::CollisionObject<S>*, void*, S&);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
