// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/collision_object.h>
#include <fcl/narrowphase/collision_request.h>
#include <fcl/narrowphase/collision_result.h>

#include <cstddef>

namespace tricover_fcl {

/// fcl::collide, reaching tricover however the program is linked; other pairs than polygons are handed to FCL. For
/// float and double.
///
/// Exact: gjk_solver_type, gjk_tolerance and the cached guess change nothing. Two polygons at different z (the doubles
/// of the poses' translations, compared exactly) don't touch. Throws std::invalid_argument for a pose that leaves the
/// plane (entries of R that mix z with x or y, or |R_zz| - 1, above tricover::kRigidTolerance), isn't rigid or isn't
/// finite: pose_a is the first object's, pose_b the second's. A half turn about an axis in the plane is a legal,
/// mirrored pose.
///
/// A hit adds one fcl::Contact. With enable_contact its pos is a common point (world), b1 and b2 are the edges there
/// (tricover::Contact::edge_a, edge_b; -1 as there), and normal is the unit vector in the plane from the first
/// polygon's origin() towards the second's (along x where they coincide): not a separating direction, and
/// penetration_depth is 0.
template <typename S>
std::size_t collide(const fcl::CollisionGeometry<S>* o1, const fcl::Transform3<S>& tf1,
                    const fcl::CollisionGeometry<S>* o2, const fcl::Transform3<S>& tf2,
                    const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result);

template <typename S>
std::size_t collide(const fcl::CollisionObject<S>* o1, const fcl::CollisionObject<S>* o2,
                    const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result);

/// fcl::DefaultCollisionFunction on top of it, for any broadphase manager: `data` is an fcl::DefaultCollisionData<S>.
template <typename S>
bool defaultCollisionFunction(fcl::CollisionObject<S>* o1, fcl::CollisionObject<S>* o2, void* data);

}  // namespace tricover_fcl
