// SPDX-License-Identifier: BSD-3-Clause
#include "tricover_fcl/continuous_collide.h"

#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <fcl/narrowphase/continuous_collision.h>

#include "queries/queries.h"
#include "shape/is_polygon.h"
#include "shape/motion_in_plane.h"
#include "tricover_fcl/registration.h"

namespace tricover_fcl {

template <typename S>
S continuousCollide(const fcl::CollisionGeometry<S>* o1, const fcl::MotionBase<S>* motion1,
                    const fcl::CollisionGeometry<S>* o2, const fcl::MotionBase<S>* motion2,
                    const fcl::ContinuousCollisionRequest<S>& request, fcl::ContinuousCollisionResult<S>& result) {
  if (!isPolygon(*o1) && !isPolygon(*o2)) {
    requireSampled(*motion1, request);  // where fcl::continuousCollide is not ours
    requireSampled(*motion2, request);
    return fcl::continuousCollide(o1, motion1, o2, motion2, request, result);
  }
  return advanceWithPoses(*o1, *motion1, *o2, *motion2, request, result);
}

template <typename S>
S continuousCollide(const fcl::CollisionGeometry<S>* o1, const fcl::Transform3<S>& tf1_beg,
                    const fcl::Transform3<S>& tf1_end, const fcl::CollisionGeometry<S>* o2,
                    const fcl::Transform3<S>& tf2_beg, const fcl::Transform3<S>& tf2_end,
                    const fcl::ContinuousCollisionRequest<S>& request, fcl::ContinuousCollisionResult<S>& result) {
  const auto motion1 = motionBetween(tf1_beg, tf1_end, request.ccd_motion_type, true);
  const auto motion2 = motionBetween(tf2_beg, tf2_end, request.ccd_motion_type, true);
  return tricover_fcl::continuousCollide(o1, motion1.get(), o2, motion2.get(), request, result);
}

template <typename S>
S continuousCollide(const fcl::CollisionObject<S>* o1, const fcl::Transform3<S>& tf1_end,
                    const fcl::CollisionObject<S>* o2, const fcl::Transform3<S>& tf2_end,
                    const fcl::ContinuousCollisionRequest<S>& request, fcl::ContinuousCollisionResult<S>& result) {
  return tricover_fcl::continuousCollide(o1->collisionGeometry().get(), o1->getTransform(), tf1_end,
                                         o2->collisionGeometry().get(), o2->getTransform(), tf2_end, request, result);
}

template <typename S>
S collide(const fcl::ContinuousCollisionObject<S>* o1, const fcl::ContinuousCollisionObject<S>* o2,
          const fcl::ContinuousCollisionRequest<S>& request, fcl::ContinuousCollisionResult<S>& result) {
  return tricover_fcl::continuousCollide<S>(o1->collisionGeometry().get(), o1->getMotion(),
                                            o2->collisionGeometry().get(), o2->getMotion(), request, result);
}

template <typename S>
bool defaultContinuousCollisionFunction(fcl::ContinuousCollisionObject<S>* o1, fcl::ContinuousCollisionObject<S>* o2,
                                        void* data) {
  auto& query = *static_cast<fcl::DefaultContinuousCollisionData<S>*>(data);
  if (!query.done) tricover_fcl::collide(o1, o2, query.request, query.result);
  return query.done;
}

#define TRICOVER_INSTANTIATE(S)                                                                                        \
  template S continuousCollide(const fcl::CollisionGeometry<S>*, const fcl::MotionBase<S>*,                            \
                               const fcl::CollisionGeometry<S>*, const fcl::MotionBase<S>*,                            \
                               const fcl::ContinuousCollisionRequest<S>&, fcl::ContinuousCollisionResult<S>&);         \
  template S continuousCollide(const fcl::CollisionGeometry<S>*, const fcl::Transform3<S>&, const fcl::Transform3<S>&, \
                               const fcl::CollisionGeometry<S>*, const fcl::Transform3<S>&, const fcl::Transform3<S>&, \
                               const fcl::ContinuousCollisionRequest<S>&, fcl::ContinuousCollisionResult<S>&);         \
  template S continuousCollide(const fcl::CollisionObject<S>*, const fcl::Transform3<S>&,                              \
                               const fcl::CollisionObject<S>*, const fcl::Transform3<S>&,                              \
                               const fcl::ContinuousCollisionRequest<S>&, fcl::ContinuousCollisionResult<S>&);         \
  template S collide(const fcl::ContinuousCollisionObject<S>*, const fcl::ContinuousCollisionObject<S>*,               \
                     const fcl::ContinuousCollisionRequest<S>&, fcl::ContinuousCollisionResult<S>&);                   \
  template bool defaultContinuousCollisionFunction(fcl::ContinuousCollisionObject<S>*,                                 \
                                                   fcl::ContinuousCollisionObject<S>*, void*);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
