// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/math/motion/motion_base.h>
#include <fcl/narrowphase/collision_request.h>
#include <fcl/narrowphase/collision_result.h>
#include <fcl/narrowphase/continuous_collision_request.h>
#include <fcl/narrowphase/continuous_collision_result.h>
#include <fcl/narrowphase/distance_request.h>
#include <fcl/narrowphase/distance_result.h>

#include <cstddef>

namespace tricover {
struct CollideOptions;
}

/// The answers of our rows of FCL's tables, whatever the solver: about two polygons or about one and another geometry.
/// At least one of the geometries has our node type. They return what a row returns.
///
/// Nothing of ours is included here, so that the files with FCL's tables, which take long, are seldom compiled again.
namespace tricover_fcl {

/// The options' margin comes on top of the shapes' own, their tolerance counts between two polygons. Null: the default.
template <typename S>
std::size_t collideGeometries(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                              const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                              const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result,
                              const tricover::CollideOptions* options = nullptr);

template <typename S>
S distanceOfGeometries(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                       const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                       const fcl::DistanceRequest<S>& request, fcl::DistanceResult<S>& result);

/// Conservative advancement.
template <typename S>
S advanceGeometries(const fcl::CollisionGeometry<S>& o1, const fcl::MotionBase<S>& motion1,
                    const fcl::CollisionGeometry<S>& o2, const fcl::MotionBase<S>& motion2,
                    const fcl::ContinuousCollisionRequest<S>& request, fcl::ContinuousCollisionResult<S>& result);

/// The same, with where the geometries are then.
template <typename S>
S advanceWithPoses(const fcl::CollisionGeometry<S>& o1, const fcl::MotionBase<S>& motion1,
                   const fcl::CollisionGeometry<S>& o2, const fcl::MotionBase<S>& motion2,
                   const fcl::ContinuousCollisionRequest<S>& request, fcl::ContinuousCollisionResult<S>& result);

}  // namespace tricover_fcl
