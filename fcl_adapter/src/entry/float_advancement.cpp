// SPDX-License-Identifier: BSD-3-Clause
#include "entry/table_rows.h"

// As float_collide.cpp.
template float fcl::continuousCollide(const fcl::CollisionGeometry<float>*, const fcl::MotionBase<float>*,
                                      const fcl::CollisionGeometry<float>*, const fcl::MotionBase<float>*,
                                      const fcl::ContinuousCollisionRequest<float>&,
                                      fcl::ContinuousCollisionResult<float>&);

namespace tricover_fcl {

template <>
void fillAdvancementTables<float>() {
  fillAdvancementTable<fcl::detail::GJKSolver_libccd<float>>();
  fillAdvancementTable<fcl::detail::GJKSolver_indep<float>>();
}

}  // namespace tricover_fcl
