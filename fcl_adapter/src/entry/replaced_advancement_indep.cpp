// SPDX-License-Identifier: BSD-3-Clause
#include "entry/table_rows.h"

// As replaced_advancement.cpp, for the other solver.
namespace fcl::detail {
TRICOVER_ADVANCE(double, GJKSolver_indep);
}
template void tricover_fcl::fillAdvancementTable<fcl::detail::GJKSolver_indep<double>>();
