// SPDX-License-Identifier: BSD-3-Clause
#include "planar_motion.h"

#include <fcl/math/motion/interp_motion.h>
#include <fcl/math/motion/screw_motion.h>
#include <fcl/math/motion/translation_motion.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <typeinfo>

#include "unsupported.h"

namespace tricover_fcl {
namespace {

template <typename S>
PlanarPose poseAt(const fcl::MotionBase<S>& motion, S time, const std::string& name) {
  fcl::Transform3<S> transform;
  motion.integrate(time);
  motion.getCurrentTransform(transform);
  return planarPose(transform, (name + (time == 0 ? " at time 0" : " at time 1")).c_str());
}

/// The motion, if it is of exactly that type: a type derived from it may move otherwise.
template <typename Motion, typename S>
const Motion* as(const fcl::MotionBase<S>& motion) {
  return typeid(motion) == typeid(Motion) ? static_cast<const Motion*>(&motion) : nullptr;
}

template <typename S>
tricover::Vec2 planar(const fcl::Vector3<S>& v) {
  return v.template head<2>().template cast<double>();
}

/// About z. Both poses keep the plane, so the axis is z's but for rounding, or the angle is nothing but rounding.
template <typename S>
double turn(S angle, const fcl::Vector3<S>& axis) {
  return static_cast<double>(angle) * static_cast<double>(axis.z());
}

}  // namespace

template <typename S>
PlanarMotion planarMotion(const fcl::MotionBase<S>& motion, const char* name) {
  const auto* translation = as<fcl::TranslationMotion<S>>(motion);
  const auto* interpolation = as<fcl::InterpMotion<S>>(motion);
  const auto* screw = as<fcl::ScrewMotion<S>>(motion);
  if (!translation && !interpolation && !screw) {
    throw UnsupportedPair(std::string("tricover: conservative advancement along ") + name + " of type " +
                          typeid(motion).name() +
                          " is not supported; fcl::TranslationMotion, InterpMotion and ScrewMotion are");
  }

  PlanarMotion result{{}, poseAt(motion, S(0), name), poseAt(motion, S(1), name)};
  const tricover::Pose& start = result.motion.start = result.start.pose;
  if (translation) {
    result.motion.shift = planar<S>(translation->getVelocity());
  } else if (interpolation) {
    result.motion.shift = planar<S>(interpolation->getLinearVelocity());
    result.motion.angle = turn<S>(interpolation->getAngularVelocity(), interpolation->getAngularAxis());
    result.motion.pivot = planar<S>(interpolation->getReferencePoint());
  } else if (screw->getAngularVelocity() != 0) {
    result.motion.angle = turn<S>(screw->getAngularVelocity(), screw->getAxis());
    result.motion.pivot = start.linear().inverse() * (planar<S>(screw->getAxisOrigin()) - start.translation());
  } else {
    // Its axis is the way to go; FCL's own transforms go its length times as far.
    result.motion.shift = planar<S>(screw->getAxis());
    result.end.pose = result.motion.at(1);
    result.end.z = result.start.z + static_cast<double>(screw->getAxis().z());
  }
  tricover::checkMotion(result.motion, name);

  // A rise as steep as the tilt that poses may have is left out, as that is.
  const double rise = std::abs(result.end.z - result.start.z);
  const double way = (result.end.pose.translation() - start.translation()).norm();
  if (result.end.upside_down != result.start.upside_down || !(rise <= tricover::kRigidTolerance * way)) {
    throw std::invalid_argument(std::string("tricover: ") + name +
                                " leaves the plane: it must keep z and turn about z");
  }
  return result;
}

template PlanarMotion planarMotion(const fcl::MotionBase<float>&, const char*);
template PlanarMotion planarMotion(const fcl::MotionBase<double>&, const char*);

}  // namespace tricover_fcl
