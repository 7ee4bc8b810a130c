// SPDX-License-Identifier: BSD-3-Clause
#include "shape/motion_in_plane.h"

#include <fcl/math/motion/interp_motion.h>
#include <fcl/math/motion/screw_motion.h>
#include <fcl/math/motion/spline_motion.h>
#include <fcl/math/motion/translation_motion.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <typeinfo>

#include "shape/errors.h"
#include "shape/planar_pose.h"
#include "tricover_fcl/trajectory_motion.h"

namespace tricover_fcl {
namespace {

using Vec3 = Eigen::Vector3d;

/// In space: a turn about an axis through a pivot, which moves on.
struct SpatialMotion {
  Vec3 shift = Vec3::Zero(), turn = Vec3::Zero(), pivot = Vec3::Zero();
  Vec3 start;  ///< where the frame is that moves
};

/// FCL's constructor from two poses leaves the reference point uninitialised, and velocities and poses with it: what
/// doesn't turn needs none.
template <typename S>
struct Ends : fcl::InterpMotion<S> {
  static const fcl::Transform3<S>& begin(const fcl::InterpMotion<S>& motion) { return motion.*(&Ends::tf1); }
  static fcl::Vector3<S> shift(const fcl::InterpMotion<S>& motion) {
    return (motion.*(&Ends::tf2)).translation() - begin(motion).translation();
  }
  /// Whether it slides, and what is in its reference point's place spoils where it begins.
  static bool areAlone(const fcl::InterpMotion<S>& motion) {
    if (motion.getAngularVelocity() != 0) return false;
    const fcl::Vector3<S>& at = begin(motion).translation();
    const S size = at.cwiseAbs().sum() + shift(motion).cwiseAbs().sum();
    // Nothing is lost by a point that is about as near.
    if (motion.getReferencePoint().cwiseAbs().sum() <= 8 * size) return false;
    fcl::Transform3<S> pose;
    motion.integrate(0);
    motion.getCurrentTransform(pose);
    return !((pose.translation() - at).cwiseAbs().sum() <= 64 * std::numeric_limits<S>::epsilon() * size);
  }
};

/// Nothing for a class that isn't FCL's.
template <typename S>
std::optional<SpatialMotion> spatialMotion(const fcl::MotionBase<S>& motion) {
  const auto wide = [](const fcl::Vector3<S>& v) { return Vec3(v.template cast<double>()); };
  const bool interpolates = typeid(motion) == typeid(fcl::InterpMotion<S>),
             slides = typeid(motion) == typeid(fcl::TranslationMotion<S>),
             screws = typeid(motion) == typeid(fcl::ScrewMotion<S>);
  if (!(interpolates || slides || screws)) return std::nullopt;
  const fcl::Transform3<S> begin = poseAt(motion, S(0));
  SpatialMotion result;
  result.start = wide(begin.translation());
  if (slides) {
    result.shift = wide(static_cast<const fcl::TranslationMotion<S>&>(motion).getVelocity());
  } else if (interpolates) {
    const auto& interpolation = static_cast<const fcl::InterpMotion<S>&>(motion);
    if (Ends<S>::areAlone(interpolation)) {
      result.shift = wide(Ends<S>::shift(interpolation));
    } else {
      result.shift = wide(interpolation.getLinearVelocity());
      result.turn = static_cast<double>(interpolation.getAngularVelocity()) * wide(interpolation.getAngularAxis());
      result.pivot = begin.template cast<double>() * wide(interpolation.getReferencePoint());
    }
  } else {
    const auto& screw = static_cast<const fcl::ScrewMotion<S>&>(motion);
    const auto angle = static_cast<double>(screw.getAngularVelocity());
    if (angle == 0) {
      result.shift = wide(screw.getAxis());  // all of the way; FCL's own transforms go its length times as far
    } else {
      result.shift = static_cast<double>(screw.getLinearVelocity()) * wide(screw.getAxis());
      result.turn = angle * wide(screw.getAxis());
      result.pivot = wide(screw.getAxisOrigin());
    }
  }
  return result;
}

/// What a pose's own rounding may lift it by out of the plane.
template <typename S>
double roundingAround(const Vec3& start, const Plane& plane, const Vec3& pivot) {
  return 8 * static_cast<double>(std::numeric_limits<S>::epsilon()) *
         (plane.translation().norm() + start.norm() + pivot.norm());
}

/// FCL keeps a spline's control points to itself and its heirs.
template <typename S>
struct ControlPoints : fcl::SplineMotion<S> {
  static const fcl::Vector3<S> (&positions(const fcl::SplineMotion<S>& spline))[4] {
    return spline.*(&ControlPoints::Td);
  }
  static const fcl::Vector3<S> (&turns(const fcl::SplineMotion<S>& spline))[4] { return spline.*(&ControlPoints::Rd); }
};

/// A uniform cubic B-spline in position and rotation vector. It turns about the plane's normal if the rotation vectors
/// are along that, and not at all if they are all the same.
template <typename S>
tricover::Motion splineInPlane(const fcl::SplineMotion<S>& spline, const Plane& plane, const char* name) {
  const auto& td = ControlPoints<S>::positions(spline);
  const auto& rd = ControlPoints<S>::turns(spline);
  const Eigen::Matrix3d inverse = plane.linear().inverse();
  std::array<tricover::Vec2, 4> positions;
  std::array<double, 4> angles;
  bool turns = false;
  double tilt = 0, lowest = 0, highest = 0, way = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 turn = inverse * rd[k].template cast<double>();
    const Vec3 position = inverse * (td[k].template cast<double>() - plane.translation());
    if (!turn.allFinite() || !position.allFinite()) refuse(name, "a control point is not finite");
    positions[k] = position.head<2>();
    angles[k] = turn.z();
    turns = turns || rd[k] != rd[0];
    tilt = std::max(tilt, turn.head<2>().norm());
    lowest = k == 0 ? position.z() : std::min(lowest, position.z());
    highest = k == 0 ? position.z() : std::max(highest, position.z());
    way = std::max(way, (positions[k] - positions[0]).norm());
  }
  const Vec3 start = poseAt<S>(spline, S(0)).translation().template cast<double>();
  const double rise = kTiltTolerance * way + roundingAround<S>(start, plane, td[0].template cast<double>());
  if ((turns && tilt > kTiltTolerance) || highest - lowest > rise) refuseDeparture(name);
  tricover::Motion in_plane = tricover::Motion::spline(positions, angles);
  in_plane.pivot = in_plane.start.translation();
  in_plane.start = tricover::Pose::Identity();
  return in_plane;
}

}  // namespace

void refuseDeparture(const char* name) {
  refuse(name, "it leaves the polygon's plane",
         std::string("shift within the plane and turn about its normal, or ") + kSampleInstead);
}

template <typename S>
std::shared_ptr<fcl::MotionBase<S>> motionBetween(const fcl::Transform3<S>& begin, const fcl::Transform3<S>& end,
                                                  fcl::CCDMotionType type, bool of_polygon) {
  if (type == fcl::CCDM_TRANS) return std::make_shared<fcl::TranslationMotion<S>>(begin, end);
  if (of_polygon && type == fcl::CCDM_SPLINE)
    refuseQuestion("ccd_motion_type", "FCL leaves a SplineMotion between two transforms uninitialised",
                   "make one of control points, and pass the motions");
  if constexpr (std::is_same_v<S, double>) {
    if (type == fcl::CCDM_LINEAR) {
      return std::make_shared<fcl::InterpMotion<S>>(begin.linear(), begin.translation(), end.linear(),
                                                    end.translation(), fcl::Vector3<S>::Zero());
    }
    if (type == fcl::CCDM_SCREW) {
      auto screw = std::make_shared<fcl::ScrewMotion<S>>(begin, end);
      if (!of_polygon || screw->getAngularVelocity() != 0) return screw;
      return std::make_shared<fcl::TranslationMotion<S>>(begin, end);
    }
    if (type == fcl::CCDM_SPLINE) return std::make_shared<fcl::SplineMotion<S>>(begin, end);
  }
  if (of_polygon)
    refuseQuestion("ccd_motion_type", "FCL has no such motion of this scalar", "CCDM_TRANS works for float, too");
  return nullptr;
}

template <typename S>
bool isSpoiled(const fcl::MotionBase<S>& motion) {
  return typeid(motion) == typeid(fcl::InterpMotion<S>) &&
         Ends<S>::areAlone(static_cast<const fcl::InterpMotion<S>&>(motion));
}

template <typename S>
fcl::Transform3<S> poseAt(const fcl::MotionBase<S>& motion, S time) {
  fcl::Transform3<S> pose;
  if (isSpoiled(motion)) {
    const auto& interpolation = static_cast<const fcl::InterpMotion<S>&>(motion);
    pose = Ends<S>::begin(interpolation);
    pose.translation() += time * Ends<S>::shift(interpolation);
    return pose;
  }
  motion.integrate(time);
  motion.getCurrentTransform(pose);
  return pose;
}

template <typename S>
std::optional<tricover::Motion> motionInPlane(const fcl::MotionBase<S>& motion, const Plane& plane, const char* name) {
  if (typeid(motion) == typeid(fcl::SplineMotion<S>))
    return splineInPlane(static_cast<const fcl::SplineMotion<S>&>(motion), plane, name);
  const std::optional<SpatialMotion> found = spatialMotion(motion);
  if (!found) return std::nullopt;
  const SpatialMotion& world = *found;
  const Eigen::Matrix3d inverse = plane.linear().inverse();
  const Vec3 shift = inverse * world.shift, turn = inverse * world.turn;
  const Vec3 pivot = inverse * (world.pivot - plane.translation());
  if (!(shift.allFinite() && turn.allFinite() && pivot.allFinite()))
    refuse(name, "its shift, turn or pivot is not finite");

  // A tilt or rise is left out that poses may have, and what S rounds the places by that FCL finds the motion from.
  const double rise = kTiltTolerance * shift.head<2>().norm() + roundingAround<S>(world.start, plane, world.pivot);
  if (!(turn.head<2>().norm() <= kTiltTolerance && std::abs(shift.z()) <= rise)) refuseDeparture(name);
  tricover::Motion in_plane;
  in_plane.shift = shift.head<2>();
  in_plane.angle = turn.z();
  in_plane.pivot = pivot.head<2>();
  tricover::checkMotion(in_plane, name);
  return in_plane;
}

tricover::Motion startingAt(tricover::Motion in_plane, const tricover::Pose& start) {
  in_plane.start = in_plane.start * start;
  in_plane.pivot = start.linear().inverse() * (in_plane.pivot - start.translation());
  return in_plane;
}

namespace {

/// Its legs begin where the ones before have brought what lies in the plane at time 0.
template <typename S>
tricover::Trajectory legsInPlane(const TrajectoryMotion<S>& motion, const Plane& plane, const char* name) {
  // From the world's coordinates, at its height, to the plane's.
  const Eigen::Matrix3d inverse = plane.linear().inverse();
  if (!(inverse.col(2).head<2>().norm() <= kTiltTolerance)) refuseDeparture(name);
  tricover::Pose to_plane;
  to_plane.linear() = inverse.topLeftCorner<2, 2>();
  to_plane.translation() = (inverse * (Vec3(0, 0, motion.z()) - plane.translation())).head<2>();
  to_plane.makeAffine();
  const tricover::Pose home = to_plane * motion.trajectory().legs().front().motion.start;
  const tricover::Pose from_home = home.inverse(Eigen::Affine);
  std::vector<tricover::Leg> legs = motion.trajectory().legs();
  for (tricover::Leg& leg : legs) {
    tricover::Motion& way = leg.motion;
    way.start = &leg == &legs.front() ? tricover::Pose::Identity() : to_plane * way.start * from_home;
    way.pivot = home * way.pivot;
    for (tricover::Vec2* shift : {&way.shift, &way.shift_2, &way.shift_3}) *shift = to_plane.linear() * *shift;
    if (to_plane.linear().determinant() > 0) continue;
    for (double* angle : {&way.angle, &way.angle_2, &way.angle_3}) *angle = -*angle;
  }
  return tricover::Trajectory(std::move(legs)).appearing().vanishing();
}

}  // namespace

template <typename S>
std::optional<tricover::Trajectory> trajectoryInPlane(const fcl::MotionBase<S>& motion, const Plane& plane,
                                                      const char* name) {
  if (typeid(motion) == typeid(TrajectoryMotion<S>))
    return legsInPlane(static_cast<const TrajectoryMotion<S>&>(motion), plane, name);
  const std::optional<tricover::Motion> in_plane = motionInPlane(motion, plane, name);
  return in_plane ? std::optional<tricover::Trajectory>(wholeOf(*in_plane)) : std::nullopt;
}

#define TRICOVER_INSTANTIATE(S)                                                                                    \
  template std::shared_ptr<fcl::MotionBase<S>> motionBetween(const fcl::Transform3<S>&, const fcl::Transform3<S>&, \
                                                             fcl::CCDMotionType, bool);                            \
  template bool isSpoiled(const fcl::MotionBase<S>&);                                                              \
  template fcl::Transform3<S> poseAt(const fcl::MotionBase<S>&, S);                                                \
  template std::optional<tricover::Motion> motionInPlane(const fcl::MotionBase<S>&, const Plane&, const char*);    \
  template std::optional<tricover::Trajectory> trajectoryInPlane(const fcl::MotionBase<S>&, const Plane&, const char*);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
