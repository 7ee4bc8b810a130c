// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/motion.h"

#include <cmath>
#include <string>

#include "numbers/cubic.h"
#include "numbers/errors.h"
#include "numbers/motion.h"
#include "numbers/rigidity.h"

namespace tricover {

Motion Motion::still(const Pose& pose) { return translation(pose, Vec2::Zero()); }

Motion Motion::translation(const Pose& start, const Vec2& shift) { return {start, shift}; }

Motion Motion::arc(const Pose& start, const Vec2& centre, double angle) {
  return {start, Vec2::Zero(), angle, start.inverse(Eigen::Affine) * centre};
}

Motion Motion::between(const Pose& start, const Pose& end, const Vec2& pivot) {
  return detail::motionBetween(start, "start", end, "end", pivot);
}

Motion detail::motionBetween(const Pose& start, const std::string& start_name, const Pose& end,
                             const std::string& end_name, const Vec2& pivot) {
  requireRigid(start, start_name.c_str());
  requireRigid(end, end_name.c_str());
  requireFinite(pivot, "pivot");
  // The rotation nearest to end * start^-1.
  const Eigen::Matrix2d rotation = end.linear() * start.linear().transpose();
  if (rotation.determinant() < 0)
    refuse(end_name, "only one of it and " + start_name + " mirrors", "give both the same determinant");
  double angle = std::atan2(rotation(1, 0) - rotation(0, 1), rotation(0, 0) + rotation(1, 1));
  if (angle == std::atan2(-0.0, -1.0)) angle = -angle;
  return {start, (end.translation() - start.translation()) + (end.linear() - start.linear()) * pivot, angle, pivot};
}

namespace {

Motion motionAlong(const Pose& start, const Vec2& pivot, const detail::Cubic<Vec2>& path,
                   const detail::Cubic<double>& rotation) {
  return {start, path.first, rotation.first, pivot, path.second, path.third, rotation.second, rotation.third};
}

/// From where the pivot and the body's angle are at time 0.
Motion splineFrom(const Vec2& position, double angle, const Vec2& pivot, const detail::Cubic<Vec2>& path,
                  const detail::Cubic<double>& rotation) {
  return motionAlong(detail::poseOfPivot(position, angle, pivot), pivot, path, rotation);
}

/// From the ends p, q and the rates u, v there.
template <typename T>
detail::Cubic<T> hermite(const T& p, const T& u, const T& q, const T& v) {
  const T change = q - p;
  return {u, 3 * change - 2 * u - v, u + v - 2 * change};
}

template <typename T>
detail::Cubic<T> basisSpline(const std::array<T, 4>& p) {
  return {(p[2] - p[0]) / 2, ((p[0] - p[1]) + (p[2] - p[1])) / 2, ((p[3] - p[0]) + 3 * (p[1] - p[2])) / 6};
}
template <typename T>
T basisSplineStart(const std::array<T, 4>& p) {
  return p[1] + ((p[0] - p[1]) + (p[2] - p[1])) / 6;
}

}  // namespace

Motion Motion::spline(const SplineEnd& begin, const SplineEnd& end, const Vec2& pivot) {
  const Motion motion = splineFrom(begin.position, begin.angle, pivot,
                                   hermite<Vec2>(begin.position, begin.velocity, end.position, end.velocity),
                                   hermite(begin.angle, begin.angular_velocity, end.angle, end.angular_velocity));
  checkMotion(motion, "spline");
  return motion;
}

Motion Motion::spline(const std::array<Vec2, 4>& positions, const std::array<double, 4>& angles, const Vec2& pivot) {
  const Motion motion = splineFrom(basisSplineStart(positions), basisSplineStart(angles), pivot, basisSpline(positions),
                                   basisSpline(angles));
  checkMotion(motion, "spline");
  return motion;
}

Pose Motion::at(double time) const {
  if (time == 0) return start;
  detail::requireFinite(time, "time");
  Pose pose = start;
  pose.translation() += detail::pathOf(*this).at(time);
  const detail::Cubic<double> rotation = detail::rotationOf(*this);
  if (rotation.isZero()) return pose;
  // The pivot's place is kept by what the lever from it to the frame's origin rotates by: (I - rotation) lever, without
  // the cancellation of 1 - cos.
  const double angle_now = rotation.at(time), sine = std::sin(angle_now), half = std::sin(angle_now / 2);
  const Vec2 lever = start.linear() * pivot;
  pose.linear() = Eigen::Rotation2Dd(angle_now).toRotationMatrix() * start.linear();
  pose.translation() += 2 * half * half * lever + sine * Vec2(lever.y(), -lever.x());
  return pose;
}

namespace {

/// What a cubic adds to its value at `begin` in `length`, over time 0 to 1.
template <typename T>
detail::Cubic<T> partOf(const detail::Cubic<T>& cubic, double begin, double length) {
  return {length * cubic.rateAt(begin), length * length * (cubic.second + 3 * begin * cubic.third),
          length * length * length * cubic.third};
}

}  // namespace

Motion Motion::part(double from, double until) const {
  detail::requireFinite(from, "from");
  detail::requireFinite(until, "until");
  const double length = until - from;
  return motionAlong(at(from), pivot, partOf(detail::pathOf(*this), from, length),
                     partOf(detail::rotationOf(*this), from, length));
}

void checkMotion(const Motion& motion, const char* name) {
  if (!detail::isPlainlyRigid(motion.start)) checkPose(motion.start, (std::string(name) + ".start").c_str());
  const auto require = [&](bool finite, const char* field) {
    if (!finite) detail::refuse(std::string(name) + "." + field, "it is not finite");
  };
  require(motion.shift.allFinite(), "shift");
  require(std::isfinite(motion.angle), "angle");
  require(motion.pivot.allFinite(), "pivot");
  require(motion.shift_2.allFinite(), "shift_2");
  require(motion.shift_3.allFinite(), "shift_3");
  require(std::isfinite(motion.angle_2), "angle_2");
  require(std::isfinite(motion.angle_3), "angle_3");
}

}  // namespace tricover
