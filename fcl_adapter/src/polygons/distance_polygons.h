// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/collision_geometry.h>
#include <fcl/narrowphase/distance_request.h>
#include <fcl/narrowphase/distance_result.h>

namespace tricover_fcl {

/// Both are polygons.
template <typename S>
S distanceOfPolygons(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                     const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                     const fcl::DistanceRequest<S>& request, fcl::DistanceResult<S>& result);

}  // namespace tricover_fcl
