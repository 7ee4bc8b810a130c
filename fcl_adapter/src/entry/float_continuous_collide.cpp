// SPDX-License-Identifier: BSD-3-Clause
#include "entry/continuous_by_solver.h"

// registration.h keeps FCL's template from being instantiated for float in users' code: this is called there.
namespace fcl {

namespace detail {
extern TRICOVER_ADVANCE(float, GJKSolver_libccd);
extern TRICOVER_ADVANCE(float, GJKSolver_indep);
}  // namespace detail

template <>
float continuousCollide(const CollisionGeometry<float>* o1, const MotionBase<float>* motion1,
                        const CollisionGeometry<float>* o2, const MotionBase<float>* motion2,
                        const ContinuousCollisionRequest<float>& request, ContinuousCollisionResult<float>& result) {
  return tricover_fcl::continuousCollideBySolver(o1, motion1, o2, motion2, request, result);
}

}  // namespace fcl
