// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/math/motion/motion_base.h>
#include <fcl/narrowphase/continuous_collision_request.h>

#include <cmath>
#include <memory>
#include <optional>

#include "shape/plane.h"
#include "tricover/motion.h"
#include "tricover/trajectory.h"

namespace tricover_fcl {

/// The remedy that errors name where a motion can't be followed.
constexpr const char* kSampleInstead = "call fcl::collide at times of your own choice";

/// The largest S that isn't above `time`, which is in [0, 1].
template <typename S>
S roundDown(double time) {
  const S rounded = static_cast<S>(time);
  return static_cast<double>(rounded) <= time ? rounded : std::nextafter(rounded, S(0));
}

/// What FCL makes of two transforms, but that a CCDM_LINEAR motion has a reference point, the origin: FCL leaves it
/// uninitialised, and turns about whatever is there. For a polygon, a CCDM_SCREW motion without a turn ends at its
/// goal, and std::logic_error is thrown for CCDM_SPLINE, of which FCL leaves all uninitialised, and for what S has no
/// motion of; otherwise that is null. Made shared, because libfcl's own delete frees what a program in C++17 gets from
/// another new (Eigen's aligned one).
template <typename S>
std::shared_ptr<fcl::MotionBase<S>> motionBetween(const fcl::Transform3<S>& begin, const fcl::Transform3<S>& end,
                                                  fcl::CCDMotionType type, bool of_polygon);

/// Whether a motion's own poses are made of uninitialised memory: see Ends.
template <typename S>
bool isSpoiled(const fcl::MotionBase<S>& motion);

/// The pose at `time` as FCL rounds it.
template <typename S>
fcl::Transform3<S> poseAt(const fcl::MotionBase<S>& motion, S time);

/// Throws std::invalid_argument: the motion leaves the plane.
[[noreturn]] void refuseDeparture(const char* name);

/// For FCL's own pairs. Throws std::logic_error for a TrajectoryMotion unless FCL samples its poses, and unless its
/// body is there all the time: FCL would take it for a motion that stands still, and an absent body for one that rests.
template <typename S>
void requireSampled(const fcl::MotionBase<S>& motion, const fcl::ContinuousCollisionRequest<S>& request);

/// What the motion does to things in `plane`, in its coordinates: from where they are at time 0, so it starts with the
/// identity. For FCL's TranslationMotion, InterpMotion, ScrewMotion and SplineMotion; these types exactly, nothing for
/// others. Throws std::invalid_argument, naming the motion, if it leaves the plane or isn't finite.
template <typename S>
std::optional<tricover::Motion> motionInPlane(const fcl::MotionBase<S>& motion, const Plane& plane, const char* name);

/// What motionInPlane() says, or a leg of trajectoryInPlane(), of a polygon that is at `start` in the plane at time 0.
tricover::Motion startingAt(tricover::Motion in_plane, const tricover::Pose& start);

/// All of the time from 0 to 1.
inline tricover::Trajectory wholeOf(const tricover::Motion& motion) { return tricover::Trajectory({{0, 1, motion}}); }

/// The same of a TrajectoryMotion, too, from time 0 to 1.
template <typename S>
std::optional<tricover::Trajectory> trajectoryInPlane(const fcl::MotionBase<S>& motion, const Plane& plane,
                                                      const char* name);

}  // namespace tricover_fcl
