// SPDX-License-Identifier: BSD-3-Clause
// Only for the files that replace fcl::continuousCollide, for double and for float.
#pragma once

#include <fcl/geometry/collision_geometry.h>
#include <fcl/math/motion/motion_base.h>
#include <fcl/narrowphase/continuous_collision_request.h>
#include <fcl/narrowphase/continuous_collision_result.h>

// fcl::continuousCollide chooses between its solvers. Two of them say "free" of whatever they don't know, and the
// default one only samples. The function is replaced, as replaced_collide.cpp replaces what is behind fcl::collide, but
// by a specialisation. That has to be declared before any header says that the template is instantiated elsewhere.
namespace fcl {

template <typename S>
FCL_EXPORT S continuousCollide(const CollisionGeometry<S>*, const MotionBase<S>*, const CollisionGeometry<S>*,
                               const MotionBase<S>*, const ContinuousCollisionRequest<S>&,
                               ContinuousCollisionResult<S>&);
template <>
FCL_EXPORT double continuousCollide(const CollisionGeometry<double>*, const MotionBase<double>*,
                                    const CollisionGeometry<double>*, const MotionBase<double>*,
                                    const ContinuousCollisionRequest<double>&, ContinuousCollisionResult<double>&);
template <>
FCL_EXPORT float continuousCollide(const CollisionGeometry<float>*, const MotionBase<float>*,
                                   const CollisionGeometry<float>*, const MotionBase<float>*,
                                   const ContinuousCollisionRequest<float>&, ContinuousCollisionResult<float>&);

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

#include <iostream>

#include "entry/table_rows.h"
#include "shape/is_polygon.h"
#include "shape/motion_in_plane.h"

namespace tricover_fcl {

/// As FCL's own, in all but polygons, which no solver of FCL's knows.
template <typename S>
S continuousCollideBySolver(const fcl::CollisionGeometry<S>* o1, const fcl::MotionBase<S>* motion1,
                            const fcl::CollisionGeometry<S>* o2, const fcl::MotionBase<S>* motion2,
                            const fcl::ContinuousCollisionRequest<S>& request,
                            fcl::ContinuousCollisionResult<S>& result) {
  if (isPolygon(*o1) || isPolygon(*o2)) return advanceWithPoses(*o1, *motion1, *o2, *motion2, request, result);
  requireSampled(*motion1, request);
  requireSampled(*motion2, request);
  const auto both = [&](fcl::OBJECT_TYPE type) {
    return o1->getObjectType() == type && o2->getObjectType() == type && request.ccd_motion_type == fcl::CCDM_TRANS;
  };
  switch (request.ccd_solver_type) {
    case fcl::CCDC_NAIVE:
      return fcl::continuousCollideNaive(o1, motion1, o2, motion2, request, result);
    case fcl::CCDC_CONSERVATIVE_ADVANCEMENT:
      return fcl::continuousCollideConservativeAdvancement(o1, motion1, o2, motion2, request, result);
    case fcl::CCDC_RAY_SHOOTING:
      if (!both(fcl::OT_GEOM)) std::cerr << "Warning! Invalid continuous collision setting\n";
      break;
    case fcl::CCDC_POLYNOMIAL_SOLVER:
      if (both(fcl::OT_BVH)) {
        return fcl::continuousCollideBVHPolynomial(o1, static_cast<const fcl::TranslationMotion<S>*>(motion1), o2,
                                                   static_cast<const fcl::TranslationMotion<S>*>(motion2), request,
                                                   result);
      }
      std::cerr << "Warning! Invalid continuous collision checking\n";
      break;
    default:
      std::cerr << "Warning! Invalid continuous collision setting\n";
  }
  return -1;
}

}  // namespace tricover_fcl
