// SPDX-License-Identifier: BSD-3-Clause
#include "entry/table_rows.h"

// As replaced_advancement.cpp, for the other solver.
template double fcl::detail::continuousCollideConservativeAdvancement(
    const CollisionGeometry<double>*, const MotionBase<double>*, const CollisionGeometry<double>*,
    const MotionBase<double>*, const GJKSolver_indep<double>*, const ContinuousCollisionRequest<double>&,
    ContinuousCollisionResult<double>&);
template void tricover_fcl::fillAdvancementTable<fcl::detail::GJKSolver_indep<double>>();
