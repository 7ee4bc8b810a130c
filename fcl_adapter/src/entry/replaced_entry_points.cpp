// SPDX-License-Identifier: BSD-3-Clause
#include "entry/rows.h"
#include "entry/tables.h"

// libfcl hides its function tables but not the functions that read them. These instantiations replace those functions
// for the whole program, wherever they come before libfcl in the search order, and read our tables, which hold FCL's
// rows and ours.
namespace fcl {

#define TRICOVER_INSTANTIATE(Solver)                                                                       \
  template std::size_t collide(const CollisionGeometry<double>*, const Transform3<double>&,                \
                               const CollisionGeometry<double>*, const Transform3<double>&, const Solver*, \
                               const CollisionRequest<double>&, CollisionResult<double>&);                 \
  template double detail::continuousCollideConservativeAdvancement(                                        \
      const CollisionGeometry<double>*, const MotionBase<double>*, const CollisionGeometry<double>*,       \
      const MotionBase<double>*, const Solver*, const ContinuousCollisionRequest<double>&,                 \
      ContinuousCollisionResult<double>&);
TRICOVER_INSTANTIATE(detail::GJKSolver_libccd<double>)
TRICOVER_INSTANTIATE(detail::GJKSolver_indep<double>)
#undef TRICOVER_INSTANTIATE

// The public level of distance, because libfcl doesn't export the solver's.
template double distance(const CollisionObject<double>*, const CollisionObject<double>*, const DistanceRequest<double>&,
                         DistanceResult<double>&);
template double distance(const CollisionGeometry<double>*, const Transform3<double>&, const CollisionGeometry<double>*,
                         const Transform3<double>&, const DistanceRequest<double>&, DistanceResult<double>&);

}  // namespace fcl

namespace tricover_fcl {

template <>
void fillTables<double>() {
  fillSolverTables<fcl::detail::GJKSolver_libccd<double>>();
  fillSolverTables<fcl::detail::GJKSolver_indep<double>>();
}

}  // namespace tricover_fcl
