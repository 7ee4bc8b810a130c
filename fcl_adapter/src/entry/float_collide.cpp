// SPDX-License-Identifier: BSD-3-Clause
#include "entry/table_rows.h"

// FCL's entry points for float are templates, instantiated in every user's code. These are for tricover_fcl's own
// functions, which hand FCL's pairs to them; they read the same tables.
namespace fcl {

template std::size_t collide(const CollisionGeometry<float>*, const Transform3<float>&, const CollisionGeometry<float>*,
                             const Transform3<float>&, const CollisionRequest<float>&, CollisionResult<float>&);

TRICOVER_COLLIDE(float, detail::GJKSolver_libccd);
TRICOVER_COLLIDE(float, detail::GJKSolver_indep);

}  // namespace fcl

template void tricover_fcl::fillCollisionTables<float>();
