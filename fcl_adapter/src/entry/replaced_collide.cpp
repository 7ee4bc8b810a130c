// SPDX-License-Identifier: BSD-3-Clause
#include "entry/table_rows.h"

// Replaces two of FCL's entry points behind the public ones: what fcl::collide asks when it has chosen its solver.
// libfcl hides its function tables but not the functions that read them. These instantiations replace those functions
// for the whole program, wherever they come before libfcl in the search order, and read our tables, which hold FCL's
// rows and ours.
namespace fcl {

#define TRICOVER_INSTANTIATE(Solver)                                                                       \
  template std::size_t collide(const CollisionGeometry<double>*, const Transform3<double>&,                \
                               const CollisionGeometry<double>*, const Transform3<double>&, const Solver*, \
                               const CollisionRequest<double>&, CollisionResult<double>&);
TRICOVER_INSTANTIATE(detail::GJKSolver_libccd<double>)
TRICOVER_INSTANTIATE(detail::GJKSolver_indep<double>)
#undef TRICOVER_INSTANTIATE

}  // namespace fcl

namespace tricover_fcl {

template <>
void fillCollisionTables<double>() {
  fillCollisionTable<fcl::detail::GJKSolver_libccd<double>>();
  fillCollisionTable<fcl::detail::GJKSolver_indep<double>>();
}

}  // namespace tricover_fcl
