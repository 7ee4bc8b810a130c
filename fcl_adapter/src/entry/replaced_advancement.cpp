// SPDX-License-Identifier: BSD-3-Clause
#include "entry/table_rows.h"

// Replaces what fcl::continuousCollide asks for conservative advancement, as replaced_collide.cpp does for
// fcl::collide.
namespace fcl::detail {

#define TRICOVER_INSTANTIATE(Solver)                                                                 \
  template double continuousCollideConservativeAdvancement(                                          \
      const CollisionGeometry<double>*, const MotionBase<double>*, const CollisionGeometry<double>*, \
      const MotionBase<double>*, const Solver*, const ContinuousCollisionRequest<double>&,           \
      ContinuousCollisionResult<double>&);
TRICOVER_INSTANTIATE(GJKSolver_libccd<double>)
TRICOVER_INSTANTIATE(GJKSolver_indep<double>)
#undef TRICOVER_INSTANTIATE

}  // namespace fcl::detail

namespace tricover_fcl {

template <>
void fillAdvancementTables<double>() {
  fillAdvancementTable<fcl::detail::GJKSolver_libccd<double>>();
  fillAdvancementTable<fcl::detail::GJKSolver_indep<double>>();
}

}  // namespace tricover_fcl
