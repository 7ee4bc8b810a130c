// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/collision_geometry.h>
#include <fcl/math/motion/motion_base.h>
#include <fcl/narrowphase/collision_request.h>
#include <fcl/narrowphase/collision_result.h>
#include <fcl/narrowphase/continuous_collision_request.h>
#include <fcl/narrowphase/continuous_collision_result.h>
#include <fcl/narrowphase/distance_request.h>
#include <fcl/narrowphase/distance_result.h>

#include <cstddef>

/// What rows answer of a polygon and another geometry.
namespace tricover_fcl {

/// The shape's margin comes on top of `margin`.
template <typename S>
std::size_t collideMixed(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                         const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                         const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result, double margin);

template <typename S>
S distanceMixed(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1, const fcl::CollisionGeometry<S>& o2,
                const fcl::Transform3<S>& tf2, const fcl::DistanceRequest<S>& request, fcl::DistanceResult<S>& result);

template <typename S>
S advanceMixed(const fcl::CollisionGeometry<S>& o1, const fcl::MotionBase<S>& motion1,
               const fcl::CollisionGeometry<S>& o2, const fcl::MotionBase<S>& motion2,
               const fcl::ContinuousCollisionRequest<S>& request, fcl::ContinuousCollisionResult<S>& result);

}  // namespace tricover_fcl
