// SPDX-License-Identifier: BSD-3-Clause
#include "shape/motion_in_plane.h"

#include <fcl/math/motion/interp_motion.h>
#include <fcl/math/motion/screw_motion.h>
#include <fcl/math/motion/translation_motion.h>

#include <cmath>
#include <limits>
#include <string>
#include <typeinfo>

#include "shape/errors.h"

namespace tricover_fcl {
namespace {

using Vec3 = Eigen::Vector3d;

/// In space: a turn about an axis through a pivot, which moves on.
struct SpatialMotion {
  Vec3 shift = Vec3::Zero(), turn = Vec3::Zero(), pivot = Vec3::Zero();
};

template <typename S>
SpatialMotion spatialMotion(const fcl::MotionBase<S>& motion, const char* name) {
  const auto wide = [](const fcl::Vector3<S>& v) { return Vec3(v.template cast<double>()); };
  SpatialMotion result;
  if (typeid(motion) == typeid(fcl::TranslationMotion<S>)) {
    result.shift = wide(static_cast<const fcl::TranslationMotion<S>&>(motion).getVelocity());
  } else if (typeid(motion) == typeid(fcl::InterpMotion<S>)) {
    const auto& interpolation = static_cast<const fcl::InterpMotion<S>&>(motion);
    result.shift = wide(interpolation.getLinearVelocity());
    result.turn = static_cast<double>(interpolation.getAngularVelocity()) * wide(interpolation.getAngularAxis());
    result.pivot = poseAt(motion, S(0)).template cast<double>() * wide(interpolation.getReferencePoint());
  } else if (typeid(motion) == typeid(fcl::ScrewMotion<S>)) {
    const auto& screw = static_cast<const fcl::ScrewMotion<S>&>(motion);
    const auto angle = static_cast<double>(screw.getAngularVelocity());
    if (angle == 0) {
      result.shift = wide(screw.getAxis());  // all of the way; FCL's own transforms go its length times as far
    } else {
      result.shift = static_cast<double>(screw.getLinearVelocity()) * wide(screw.getAxis());
      result.turn = angle * wide(screw.getAxis());
      result.pivot = wide(screw.getAxisOrigin());
    }
  } else {
    refuseQuestion(name, "conservative advancement doesn't know the motion " + className(typeid(motion)),
                   std::string("move by fcl::TranslationMotion, InterpMotion or ScrewMotion, or ") + kSampleInstead);
  }
  return result;
}

}  // namespace

template <typename S>
fcl::Transform3<S> poseAt(const fcl::MotionBase<S>& motion, S time) {
  fcl::Transform3<S> pose;
  motion.integrate(time);
  motion.getCurrentTransform(pose);
  return pose;
}

template <typename S>
tricover::Motion motionInPlane(const fcl::MotionBase<S>& motion, const Plane& plane, const char* name) {
  const SpatialMotion world = spatialMotion(motion, name);
  const Eigen::Matrix3d inverse = plane.linear().inverse();
  const Vec3 shift = inverse * world.shift, turn = inverse * world.turn;
  const Vec3 pivot = inverse * (world.pivot - plane.translation());
  if (!(shift.allFinite() && turn.allFinite() && pivot.allFinite()))
    refuse(name, "its shift, turn or pivot is not finite");

  // A tilt or rise is left out that poses may have, and what S rounds the places by that FCL finds the motion from.
  const double rounding = 8 * static_cast<double>(std::numeric_limits<S>::epsilon()) *
                          (plane.translation().norm() +
                           poseAt(motion, S(0)).translation().template cast<double>().norm() + world.pivot.norm());
  const double rise = tricover::kRigidTolerance * shift.head<2>().norm() + rounding;
  if (!(turn.head<2>().norm() <= tricover::kRigidTolerance && std::abs(shift.z()) <= rise)) {
    refuse(name, "it leaves the polygon's plane",
           std::string("shift within the plane and turn about its normal, or ") + kSampleInstead);
  }
  tricover::Motion in_plane;
  in_plane.shift = shift.head<2>();
  in_plane.angle = turn.z();
  in_plane.pivot = pivot.head<2>();
  tricover::checkMotion(in_plane, name);
  return in_plane;
}

template fcl::Transform3<float> poseAt(const fcl::MotionBase<float>&, float);
template fcl::Transform3<double> poseAt(const fcl::MotionBase<double>&, double);
template tricover::Motion motionInPlane(const fcl::MotionBase<float>&, const Plane&, const char*);
template tricover::Motion motionInPlane(const fcl::MotionBase<double>&, const Plane&, const char*);

}  // namespace tricover_fcl
