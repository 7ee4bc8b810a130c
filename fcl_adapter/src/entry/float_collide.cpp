// SPDX-License-Identifier: BSD-3-Clause
#include "entry/table_rows.h"

// FCL's entry points for float are templates, instantiated in every user's code. These are for tricover_fcl's own
// functions, which hand FCL's pairs to them; they read the same tables.
namespace fcl {

template std::size_t collide(const CollisionGeometry<float>*, const Transform3<float>&, const CollisionGeometry<float>*,
                             const Transform3<float>&, const CollisionRequest<float>&, CollisionResult<float>&);

#define TRICOVER_INSTANTIATE(Solver)                                                                     \
  template std::size_t collide(const CollisionGeometry<float>*, const Transform3<float>&,                \
                               const CollisionGeometry<float>*, const Transform3<float>&, const Solver*, \
                               const CollisionRequest<float>&, CollisionResult<float>&);
TRICOVER_INSTANTIATE(detail::GJKSolver_libccd<float>)
TRICOVER_INSTANTIATE(detail::GJKSolver_indep<float>)
#undef TRICOVER_INSTANTIATE

}  // namespace fcl

namespace tricover_fcl {

template <>
void fillCollisionTables<float>() {
  fillCollisionTable<fcl::detail::GJKSolver_libccd<float>>();
  fillCollisionTable<fcl::detail::GJKSolver_indep<float>>();
}

}  // namespace tricover_fcl
