// SPDX-License-Identifier: BSD-3-Clause
#include "entry/table_rows.h"

// As float_advancement.cpp, for the other solver.
template float fcl::detail::continuousCollideConservativeAdvancement(
    const CollisionGeometry<float>*, const MotionBase<float>*, const CollisionGeometry<float>*,
    const MotionBase<float>*, const GJKSolver_indep<float>*, const ContinuousCollisionRequest<float>&,
    ContinuousCollisionResult<float>&);
template void tricover_fcl::fillAdvancementTable<fcl::detail::GJKSolver_indep<float>>();
