// SPDX-License-Identifier: BSD-3-Clause
#include "entry/table_rows.h"

// Replaces what fcl::continuousCollide asks for conservative advancement, as replaced_collide.cpp does for
// fcl::collide. The other solver's table, which takes a compiler as long, is in replaced_advancement_indep.cpp.
namespace fcl::detail {
TRICOVER_ADVANCE(double, GJKSolver_libccd);
}
extern template void tricover_fcl::fillAdvancementTable<fcl::detail::GJKSolver_indep<double>>();
template void tricover_fcl::fillAdvancementTables<double>();
