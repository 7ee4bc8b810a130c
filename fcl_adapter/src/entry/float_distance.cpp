// SPDX-License-Identifier: BSD-3-Clause
#include "entry/table_rows.h"

// As float_collide.cpp.
template float fcl::distance(const fcl::CollisionGeometry<float>*, const fcl::Transform3<float>&,
                             const fcl::CollisionGeometry<float>*, const fcl::Transform3<float>&,
                             const fcl::DistanceRequest<float>&, fcl::DistanceResult<float>&);

template void tricover_fcl::fillDistanceTables<float>();
