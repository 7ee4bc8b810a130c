// SPDX-License-Identifier: BSD-3-Clause
#include "entry/rows.h"
#include "entry/tables.h"

// For tricover_fcl's own functions. FCL's entry points for float are templates, instantiated in every user's code; they
// read the same tables as these.
template std::size_t fcl::collide(const fcl::CollisionGeometry<float>*, const fcl::Transform3<float>&,
                                  const fcl::CollisionGeometry<float>*, const fcl::Transform3<float>&,
                                  const fcl::CollisionRequest<float>&, fcl::CollisionResult<float>&);
template float fcl::distance(const fcl::CollisionGeometry<float>*, const fcl::Transform3<float>&,
                             const fcl::CollisionGeometry<float>*, const fcl::Transform3<float>&,
                             const fcl::DistanceRequest<float>&, fcl::DistanceResult<float>&);
template float fcl::continuousCollide(const fcl::CollisionGeometry<float>*, const fcl::MotionBase<float>*,
                                      const fcl::CollisionGeometry<float>*, const fcl::MotionBase<float>*,
                                      const fcl::ContinuousCollisionRequest<float>&,
                                      fcl::ContinuousCollisionResult<float>&);

namespace tricover_fcl {

template <>
void fillTables<float>() {
  fillSolverTables<fcl::detail::GJKSolver_libccd<float>>();
  fillSolverTables<fcl::detail::GJKSolver_indep<float>>();
}

}  // namespace tricover_fcl
