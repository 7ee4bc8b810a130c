// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/collision_geometry.h>
#include <fcl/math/motion/motion_base.h>
#include <fcl/narrowphase/continuous_collision_request.h>
#include <fcl/narrowphase/continuous_collision_result.h>

namespace tricover_fcl {

/// Both are polygons.
template <typename S>
S advancePolygons(const fcl::CollisionGeometry<S>& o1, const fcl::MotionBase<S>& motion1,
                  const fcl::CollisionGeometry<S>& o2, const fcl::MotionBase<S>& motion2,
                  const fcl::ContinuousCollisionRequest<S>& request, fcl::ContinuousCollisionResult<S>& result);

}  // namespace tricover_fcl
