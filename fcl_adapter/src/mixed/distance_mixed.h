// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/distance_request.h>
#include <fcl/narrowphase/distance_result.h>

#include "tricover_fcl/polygon_shape.h"

namespace tricover_fcl {

/// Exactly one of the two is a polygon.
template <typename S>
S distanceMixed(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1, const fcl::CollisionGeometry<S>& o2,
                const fcl::Transform3<S>& tf2, const fcl::DistanceRequest<S>& request, fcl::DistanceResult<S>& result);

}  // namespace tricover_fcl
