// SPDX-License-Identifier: BSD-3-Clause
#include "entry/dispatch.h"

#include "mixed/advance_mixed.h"
#include "mixed/collide_mixed.h"
#include "mixed/distance_mixed.h"
#include "polygons/advance_polygons.h"
#include "polygons/collide_polygons.h"
#include "polygons/distance_polygons.h"
#include "shape/errors.h"
#include "shape/is_polygon.h"

namespace tricover_fcl {
namespace {

const tricover::CollideOptions kNoOptions;

}  // namespace

template <typename S>
std::size_t collideGeometries(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                              const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                              const fcl::CollisionRequest<S>& request, const tricover::CollideOptions& options,
                              fcl::CollisionResult<S>& result) {
  const bool first = isPolygon(o1), second = isPolygon(o2);
  if (first && second) return collidePolygons(o1, tf1, o2, tf2, request, options, result);
  if (!first && !second) refusePair("collide", o1, o2);
  return collideMixed(o1, tf1, o2, tf2, request, options, result);
}

template <typename S>
std::size_t collideGeometries(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                              const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                              const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result) {
  return collideGeometries(o1, tf1, o2, tf2, request, kNoOptions, result);
}

template <typename S>
S distanceOfGeometries(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                       const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                       const fcl::DistanceRequest<S>& request, fcl::DistanceResult<S>& result) {
  const bool first = isPolygon(o1), second = isPolygon(o2);
  if (first && second) return distanceOfPolygons(o1, tf1, o2, tf2, request, result);
  if (!first && !second) refusePair("distance", o1, o2);
  return distanceMixed(o1, tf1, o2, tf2, request, result);
}

template <typename S>
S advanceGeometries(const fcl::CollisionGeometry<S>& o1, const fcl::MotionBase<S>& motion1,
                    const fcl::CollisionGeometry<S>& o2, const fcl::MotionBase<S>& motion2,
                    const fcl::ContinuousCollisionRequest<S>& request, fcl::ContinuousCollisionResult<S>& result) {
  if (isPolygon(o1) != isPolygon(o2)) return advanceMixed(o1, motion1, o2, motion2, request, result);
  if (!isPolygon(o1)) refusePair("conservative advancement", o1, o2);
  return advancePolygons(o1, motion1, o2, motion2, request, result);
}

#define TRICOVER_INSTANTIATE(S)                                                                            \
  template std::size_t collideGeometries(const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&,      \
                                         const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&,      \
                                         const fcl::CollisionRequest<S>&, const tricover::CollideOptions&, \
                                         fcl::CollisionResult<S>&);                                        \
  template std::size_t collideGeometries(const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&,      \
                                         const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&,      \
                                         const fcl::CollisionRequest<S>&, fcl::CollisionResult<S>&);       \
  template S distanceOfGeometries(const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&,             \
                                  const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&,             \
                                  const fcl::DistanceRequest<S>&, fcl::DistanceResult<S>&);                \
  template S advanceGeometries(const fcl::CollisionGeometry<S>&, const fcl::MotionBase<S>&,                \
                               const fcl::CollisionGeometry<S>&, const fcl::MotionBase<S>&,                \
                               const fcl::ContinuousCollisionRequest<S>&, fcl::ContinuousCollisionResult<S>&);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
