// SPDX-License-Identifier: BSD-3-Clause
#include "entry/table_rows.h"

// Replaces what fcl::continuousCollide asks for conservative advancement, as replaced_collide.cpp does for
// fcl::collide. The other solver's table, which takes a compiler as long, is in replaced_advancement_indep.cpp.
template double fcl::detail::continuousCollideConservativeAdvancement(
    const CollisionGeometry<double>*, const MotionBase<double>*, const CollisionGeometry<double>*,
    const MotionBase<double>*, const GJKSolver_libccd<double>*, const ContinuousCollisionRequest<double>&,
    ContinuousCollisionResult<double>&);

namespace tricover_fcl {

extern template void fillAdvancementTable<fcl::detail::GJKSolver_indep<double>>();

template <>
void fillAdvancementTables<double>() {
  fillAdvancementTable<fcl::detail::GJKSolver_libccd<double>>();
  fillAdvancementTable<fcl::detail::GJKSolver_indep<double>>();
}

}  // namespace tricover_fcl
