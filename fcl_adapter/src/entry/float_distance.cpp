// SPDX-License-Identifier: BSD-3-Clause
#include "entry/table_rows.h"

// As float_collide.cpp.
template float fcl::distance(const fcl::CollisionGeometry<float>*, const fcl::Transform3<float>&,
                             const fcl::CollisionGeometry<float>*, const fcl::Transform3<float>&,
                             const fcl::DistanceRequest<float>&, fcl::DistanceResult<float>&);

namespace tricover_fcl {

template <>
void fillDistanceTables<float>() {
  fillDistanceTable<fcl::detail::GJKSolver_libccd<float>>();
  fillDistanceTable<fcl::detail::GJKSolver_indep<float>>();
}

}  // namespace tricover_fcl
