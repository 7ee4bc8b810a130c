// SPDX-License-Identifier: BSD-3-Clause
#include "entry/dispatch.h"

#include <iostream>
#include <limits>

#include "mixed/mixed.h"
#include "polygons/polygons.h"
#include "shape/is_polygon.h"

namespace tricover_fcl {
namespace {

/// What FCL does of a pair that it has no function for: fcl::TriangleP's row is ours, but not its pairs.
template <typename S>
void warnAsFcl(const char* function, const fcl::CollisionGeometry<S>& o1, const fcl::CollisionGeometry<S>& o2) {
  std::cerr << "Warning: " << function << " function between node type " << o1.getNodeType() << " and node type "
            << o2.getNodeType() << " is not supported\n";
}

template <typename S>
[[gnu::noinline]] std::size_t collideOthers(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                                            const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                                            const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result,
                                            double margin, double tolerance) {
  const bool first = isPolygon(o1), second = isPolygon(o2);
  if (first && second) return collidePolygons(o1, tf1, o2, tf2, request, result, margin, tolerance);
  if (first || second) return collideMixed(o1, tf1, o2, tf2, request, result, margin);
  warnAsFcl("collision", o1, o2);
  return 0;
}

}  // namespace

template <typename S>
std::size_t collideGeometries(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                              const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                              const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result, double margin,
                              double tolerance) {
  // FCL's own call costs 20 ns: a frame around this one would be felt.
  return isPlainlyPolygon(o1) && isPlainlyPolygon(o2)
             ? collidePolygons(o1, tf1, o2, tf2, request, result, margin, tolerance)
             : collideOthers(o1, tf1, o2, tf2, request, result, margin, tolerance);
}

template <typename S>
S distanceOfGeometries(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                       const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                       const fcl::DistanceRequest<S>& request, fcl::DistanceResult<S>& result) {
  const bool first = isPolygon(o1), second = isPolygon(o2);
  if (first && second) return distanceOfPolygons(o1, tf1, o2, tf2, request, result);
  if (first || second) return distanceMixed(o1, tf1, o2, tf2, request, result);
  warnAsFcl("distance", o1, o2);
  return std::numeric_limits<S>::max();
}

template <typename S>
S advanceGeometries(const fcl::CollisionGeometry<S>& o1, const fcl::MotionBase<S>& motion1,
                    const fcl::CollisionGeometry<S>& o2, const fcl::MotionBase<S>& motion2,
                    const fcl::ContinuousCollisionRequest<S>& request, fcl::ContinuousCollisionResult<S>& result) {
  if (isPolygon(o1) != isPolygon(o2)) return advanceMixed(o1, motion1, o2, motion2, request, result);
  if (isPolygon(o1)) return advancePolygons(o1, motion1, o2, motion2, request, result);
  warnAsFcl("collision", o1, o2);
  return -1;
}

#define TRICOVER_INSTANTIATE(S)                                                                                      \
  template std::size_t collideGeometries(const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&,                \
                                         const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&,                \
                                         const fcl::CollisionRequest<S>&, fcl::CollisionResult<S>&, double, double); \
  template S distanceOfGeometries(const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&,                       \
                                  const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&,                       \
                                  const fcl::DistanceRequest<S>&, fcl::DistanceResult<S>&);                          \
  template S advanceGeometries(const fcl::CollisionGeometry<S>&, const fcl::MotionBase<S>&,                          \
                               const fcl::CollisionGeometry<S>&, const fcl::MotionBase<S>&,                          \
                               const fcl::ContinuousCollisionRequest<S>&, fcl::ContinuousCollisionResult<S>&);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
