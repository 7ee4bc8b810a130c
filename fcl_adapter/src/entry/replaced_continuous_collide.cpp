// SPDX-License-Identifier: BSD-3-Clause
#include "entry/continuous_by_solver.h"

namespace fcl {

namespace detail {
extern TRICOVER_ADVANCE(double, GJKSolver_libccd);
extern TRICOVER_ADVANCE(double, GJKSolver_indep);
}  // namespace detail

/// As FCL's own, but for motionBetween().
template <>
double continuousCollide(const CollisionGeometry<double>* o1, const Transform3<double>& tf1_beg,
                         const Transform3<double>& tf1_end, const CollisionGeometry<double>* o2,
                         const Transform3<double>& tf2_beg, const Transform3<double>& tf2_end,
                         const ContinuousCollisionRequest<double>& request, ContinuousCollisionResult<double>& result) {
  const auto between = [&, has_polygon = tricover_fcl::isPolygon(*o1) || tricover_fcl::isPolygon(*o2)](
                           const Transform3<double>& begin, const Transform3<double>& end) {
    return tricover_fcl::motionBetween(begin, end, request.ccd_motion_type, has_polygon);
  };
  const auto motion1 = between(tf1_beg, tf1_end), motion2 = between(tf2_beg, tf2_end);
  return continuousCollide<double>(o1, motion1.get(), o2, motion2.get(), request, result);
}

template <>
double continuousCollide(const CollisionGeometry<double>* o1, const MotionBase<double>* motion1,
                         const CollisionGeometry<double>* o2, const MotionBase<double>* motion2,
                         const ContinuousCollisionRequest<double>& request, ContinuousCollisionResult<double>& result) {
  return tricover_fcl::continuousCollideBySolver(o1, motion1, o2, motion2, request, result);
}

}  // namespace fcl
