// SPDX-License-Identifier: BSD-3-Clause
#include "entry/table_rows.h"

// Replaces fcl::distance itself, as replaced_collide.cpp replaces what is behind fcl::collide: libfcl doesn't export
// the functions that know the solver.
namespace fcl {

template double distance(const CollisionObject<double>*, const CollisionObject<double>*, const DistanceRequest<double>&,
                         DistanceResult<double>&);
template double distance(const CollisionGeometry<double>*, const Transform3<double>&, const CollisionGeometry<double>*,
                         const Transform3<double>&, const DistanceRequest<double>&, DistanceResult<double>&);

}  // namespace fcl

template void tricover_fcl::fillDistanceTables<double>();
