// SPDX-License-Identifier: BSD-3-Clause
#include "entry/table_rows.h"

// As float_collide.cpp. The other solver's table is in float_advancement_indep.cpp.
namespace fcl::detail {
TRICOVER_ADVANCE(float, GJKSolver_libccd);
}
extern template void tricover_fcl::fillAdvancementTable<fcl::detail::GJKSolver_indep<float>>();
template void tricover_fcl::fillAdvancementTables<float>();
