// SPDX-License-Identifier: BSD-3-Clause
#include <fcl/geometry/collision_geometry.h>
#include <fcl/math/motion/motion_base.h>
#include <fcl/narrowphase/continuous_collision_request.h>
#include <fcl/narrowphase/continuous_collision_result.h>

// fcl::continuousCollide chooses between its solvers, two of which say "free" of whatever they don't know. It is
// replaced for double, as replaced_collide.cpp replaces what is behind fcl::collide, but by a specialisation. That has
// to be declared before FCL's header says that the template is instantiated elsewhere.
namespace fcl {

template <typename S>
FCL_EXPORT S continuousCollide(const CollisionGeometry<S>*, const MotionBase<S>*, const CollisionGeometry<S>*,
                               const MotionBase<S>*, const ContinuousCollisionRequest<S>&,
                               ContinuousCollisionResult<S>&);
template <>
FCL_EXPORT double continuousCollide(const CollisionGeometry<double>*, const MotionBase<double>*,
                                    const CollisionGeometry<double>*, const MotionBase<double>*,
                                    const ContinuousCollisionRequest<double>&, ContinuousCollisionResult<double>&);

template <typename S>
FCL_EXPORT S continuousCollide(const CollisionGeometry<S>*, const Transform3<S>&, const Transform3<S>&,
                               const CollisionGeometry<S>*, const Transform3<S>&, const Transform3<S>&,
                               const ContinuousCollisionRequest<S>&, ContinuousCollisionResult<S>&);
template <>
FCL_EXPORT double continuousCollide(const CollisionGeometry<double>*, const Transform3<double>&,
                                    const Transform3<double>&, const CollisionGeometry<double>*,
                                    const Transform3<double>&, const Transform3<double>&,
                                    const ContinuousCollisionRequest<double>&, ContinuousCollisionResult<double>&);

}  // namespace fcl

#include <fcl/narrowphase/continuous_collision.h>

#include <iostream>

#include "entry/fill_tables.h"
#include "shape/errors.h"
#include "shape/is_polygon.h"
#include "shape/motion_in_plane.h"

namespace tricover_fcl {
namespace {

void requireSolver(fcl::CCDSolverType solver) {
  if (solver != fcl::CCDC_RAY_SHOOTING && solver != fcl::CCDC_POLYNOMIAL_SOLVER) return;
  refuseQuestion("ccd_solver_type", "FCL's ray shooting and polynomial solver know no polygons, and would say \"free\"",
                 "ask for CCDC_CONSERVATIVE_ADVANCEMENT");
}

}  // namespace
}  // namespace tricover_fcl

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

/// As FCL's own, in all but polygons.
template <>
double continuousCollide(const CollisionGeometry<double>* o1, const MotionBase<double>* motion1,
                         const CollisionGeometry<double>* o2, const MotionBase<double>* motion2,
                         const ContinuousCollisionRequest<double>& request, ContinuousCollisionResult<double>& result) {
  const bool has_polygon = tricover_fcl::isPolygon(*o1) || tricover_fcl::isPolygon(*o2);
  if (has_polygon) tricover_fcl::requireSolver(request.ccd_solver_type);
  const auto both = [&](OBJECT_TYPE type) {
    return o1->getObjectType() == type && o2->getObjectType() == type && request.ccd_motion_type == CCDM_TRANS;
  };
  switch (request.ccd_solver_type) {
    case CCDC_NAIVE:
      return continuousCollideNaive(o1, motion1, o2, motion2, request, result);
    case CCDC_CONSERVATIVE_ADVANCEMENT: {
      const double time = continuousCollideConservativeAdvancement(o1, motion1, o2, motion2, request, result);
      if (has_polygon && result.is_collide) {
        if (tricover_fcl::isSpoiled(*motion1)) result.contact_tf1 = tricover_fcl::poseAt(*motion1, time);
        if (tricover_fcl::isSpoiled(*motion2)) result.contact_tf2 = tricover_fcl::poseAt(*motion2, time);
      }
      return time;
    }
    case CCDC_RAY_SHOOTING:
      if (!both(OT_GEOM)) std::cerr << "Warning! Invalid continuous collision setting\n";
      break;
    case CCDC_POLYNOMIAL_SOLVER:
      if (both(OT_BVH)) {
        return continuousCollideBVHPolynomial(o1, static_cast<const TranslationMotion<double>*>(motion1), o2,
                                              static_cast<const TranslationMotion<double>*>(motion2), request, result);
      }
      std::cerr << "Warning! Invalid continuous collision checking\n";
      break;
    default:
      std::cerr << "Warning! Invalid continuous collision setting\n";
  }
  return -1;
}

}  // namespace fcl
