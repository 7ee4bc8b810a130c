// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/math/motion/motion_base.h>
#include <fcl/narrowphase/continuous_collision_request.h>
#include <fcl/narrowphase/continuous_collision_result.h>

#include "tricover_fcl/polygon_shape.h"

namespace tricover_fcl {

/// Exactly one of the two is a polygon.
template <typename S>
S advanceMixed(const fcl::CollisionGeometry<S>& o1, const fcl::MotionBase<S>& motion1,
               const fcl::CollisionGeometry<S>& o2, const fcl::MotionBase<S>& motion2,
               const fcl::ContinuousCollisionRequest<S>& request, fcl::ContinuousCollisionResult<S>& result);

}  // namespace tricover_fcl
