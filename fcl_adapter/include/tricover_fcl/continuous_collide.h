// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/math/motion/motion_base.h>
#include <fcl/narrowphase/collision_object.h>
#include <fcl/narrowphase/continuous_collision_object.h>
#include <fcl/narrowphase/continuous_collision_request.h>
#include <fcl/narrowphase/continuous_collision_result.h>

#include "tricover/export.h"

namespace tricover_fcl {

/// fcl::continuousCollide, reaching tricover however the program is linked; other pairs than polygons are handed to
/// FCL. Returns result.time_of_contact, which is 1 where there is none.
///
/// Two polygons: exact, whatever the ccd_solver_type. The time is never later than the first contact and at most
/// toc_err earlier (tricover::timeOfImpact); contact at the end counts, and so does a pass that only touches. Shapes
/// with margins are in contact as soon as they are as near as the sum of those. num_max_iterations changes nothing.
/// fcl::continuousCollide answers the same: FCL's default solver, CCDC_NAIVE, which samples, and CCDC_RAY_SHOOTING and
/// CCDC_POLYNOMIAL_SOLVER, which know no polygons, are never asked about one. For float, whose fcl::continuousCollide
/// is a template that is compiled into users' code, this holds in files that include a header of tricover_fcl. All of
/// FCL's own motions are followed, a SplineMotion by its control points; for many one after the other see
/// TrajectoryMotion. A motion that leaves the plane (it must keep z and turn about z) is refused.
///
/// A motion class of the user's own is followed by its poses and its computeMotionBound for FCL's
/// BVMotionBoundVisitor: that, asked after integrate(t), must be no less than the speed, in the visitor's direction, of
/// any point of the geometry from t to 1. A bound of 0 at the start means that it stands still, and nothing more is
/// asked. The promises above hold as far as the bound does, but for 1e-13 of size and distance, within which it counts
/// as contact. The better the bound, the fewer poses are asked for: passing by at a distance d takes about way / d of
/// them. The search takes at most 16 / toc_err steps (65,536 at least, a million at most) for each leg of the other
/// motion. After so many it reports a contact at the time that it has reached: nothing is met before, and nothing is
/// known about later. A bound that isn't finite is refused, and so is a motion that hands itself to the
/// visitor, because FCL's visitors know FCL's motions alone and say 0 of others.
///
/// Other geometries: as long as both motions keep the polygon's plane as it lies at time 0 (they shift within it and
/// turn about its normal), wherever that is in space; other motions are refused. A plane or halfspace
/// needs a motion of FCL's, or one that stands still. A round geometry that is neither a disc nor a stadium is taken
/// for a polygon around it, at most 1e-4 of its size outside.
///
/// FCL's motions turn by quaternions, so their first and last pose are those given up to rounding. Three of them have a
/// bug in FCL 0.7.0 that shows where two transforms are given, but not here, nor of polygons in fcl::continuousCollide
/// for double:
/// - InterpMotion (CCDM_LINEAR) leaves the point that moves on a straight line uninitialised; here it is the origin.
///   One made by yourself needs that point if it turns.
/// - ScrewMotion (CCDM_SCREW) without a turn goes on beyond its goal, to its own length times the way; here it is a
///   TranslationMotion. If you make one yourself, its goal is taken for the end, but contact_tf1 and contact_tf2 are
///   its own poses.
/// - SplineMotion (CCDM_SPLINE) made from two transforms is left uninitialised as a whole; here that is
///   refused. Make it from control points.
///
/// \throws std::invalid_argument for a motion that leaves the polygon's plane, or isn't rigid or finite
/// \throws std::logic_error for CCDM_SPLINE between two transforms, for a motion of the user's own whose bound isn't
/// finite or that hands itself to the visitor, and for a plane or halfspace that one of those moves
///
/// \snippet fcl.cpp fcl continuous collide
template <typename S>
TRICOVER_EXPORT S continuousCollide(const fcl::CollisionGeometry<S>* o1, const fcl::MotionBase<S>* motion1,
                                    const fcl::CollisionGeometry<S>* o2, const fcl::MotionBase<S>* motion2,
                                    const fcl::ContinuousCollisionRequest<S>& request,
                                    fcl::ContinuousCollisionResult<S>& result);

/// Along motions from pose to pose of request.ccd_motion_type. For float, FCL can translate only (CCDM_TRANS): its
/// other motions don't compile.
template <typename S>
TRICOVER_EXPORT S continuousCollide(const fcl::CollisionGeometry<S>* o1, const fcl::Transform3<S>& tf1_beg,
                                    const fcl::Transform3<S>& tf1_end, const fcl::CollisionGeometry<S>* o2,
                                    const fcl::Transform3<S>& tf2_beg, const fcl::Transform3<S>& tf2_end,
                                    const fcl::ContinuousCollisionRequest<S>& request,
                                    fcl::ContinuousCollisionResult<S>& result);

/// From where the objects are.
template <typename S>
TRICOVER_EXPORT S continuousCollide(const fcl::CollisionObject<S>* o1, const fcl::Transform3<S>& tf1_end,
                                    const fcl::CollisionObject<S>* o2, const fcl::Transform3<S>& tf2_end,
                                    const fcl::ContinuousCollisionRequest<S>& request,
                                    fcl::ContinuousCollisionResult<S>& result);

/// fcl::collide of two objects with motions.
/// \snippet fcl.cpp fcl collide of moving objects
template <typename S>
TRICOVER_EXPORT S collide(const fcl::ContinuousCollisionObject<S>* o1, const fcl::ContinuousCollisionObject<S>* o2,
                          const fcl::ContinuousCollisionRequest<S>& request, fcl::ContinuousCollisionResult<S>& result);

/// fcl::DefaultContinuousCollisionFunction on top of it: `data` is an fcl::DefaultContinuousCollisionData<S>.
/// \snippet fcl.cpp fcl collide of moving objects
template <typename S>
TRICOVER_EXPORT bool defaultContinuousCollisionFunction(fcl::ContinuousCollisionObject<S>* o1,
                                                        fcl::ContinuousCollisionObject<S>* o2, void* data);

}  // namespace tricover_fcl
