// SPDX-License-Identifier: BSD-3-Clause
#include "entry/table_rows.h"

// Replaces two of FCL's entry points behind the public ones: what fcl::collide asks when it has chosen its solver.
// libfcl hides its function tables but not the functions that read them. These instantiations replace those functions
// for the whole program, wherever they come before libfcl in the search order, and read our tables, which hold FCL's
// rows and ours.
namespace fcl {

TRICOVER_COLLIDE(double, detail::GJKSolver_libccd);
TRICOVER_COLLIDE(double, detail::GJKSolver_indep);

}  // namespace fcl

template void tricover_fcl::fillCollisionTables<double>();
