// SPDX-License-Identifier: BSD-3-Clause
#include "entry/table_rows.h"

// As float_collide.cpp. The other solver's table is in float_advancement_indep.cpp.
namespace fcl {

extern template float detail::continuousCollideConservativeAdvancement(
    const CollisionGeometry<float>*, const MotionBase<float>*, const CollisionGeometry<float>*,
    const MotionBase<float>*, const detail::GJKSolver_indep<float>*, const ContinuousCollisionRequest<float>&,
    ContinuousCollisionResult<float>&);
template float continuousCollide(const CollisionGeometry<float>*, const MotionBase<float>*,
                                 const CollisionGeometry<float>*, const MotionBase<float>*,
                                 const ContinuousCollisionRequest<float>&, ContinuousCollisionResult<float>&);

}  // namespace fcl

namespace tricover_fcl {

extern template void fillAdvancementTable<fcl::detail::GJKSolver_indep<float>>();

template <>
void fillAdvancementTables<float>() {
  fillAdvancementTable<fcl::detail::GJKSolver_libccd<float>>();
  fillAdvancementTable<fcl::detail::GJKSolver_indep<float>>();
}

}  // namespace tricover_fcl
