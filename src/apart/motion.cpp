// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/motion.h"

#include <cmath>
#include <string>

#include "numbers/errors.h"

namespace tricover {

Motion Motion::still(const Pose& pose) { return translation(pose, Vec2::Zero()); }

Motion Motion::translation(const Pose& start, const Vec2& shift) {
  Motion motion;
  motion.start = start;
  motion.shift = shift;
  return motion;
}

Motion Motion::between(const Pose& start, const Pose& end, const Vec2& pivot) {
  checkPose(start, "start");
  checkPose(end, "end");
  if (!pivot.allFinite()) detail::refuse("pivot", "a coordinate is not finite");
  // The rotation nearest to end * start^-1.
  const Eigen::Matrix2d turn = end.linear() * start.linear().transpose();
  if (turn.determinant() < 0) detail::refuse("end", "it mirrors where start doesn't, or the other way round");
  Motion motion;
  motion.start = start;
  motion.pivot = pivot;
  motion.angle = std::atan2(turn(1, 0) - turn(0, 1), turn(0, 0) + turn(1, 1));
  if (motion.angle == std::atan2(-0.0, -1.0)) motion.angle = -motion.angle;
  motion.shift = (end.translation() - start.translation()) + (end.linear() - start.linear()) * pivot;
  return motion;
}

Pose Motion::at(double time) const {
  if (time == 0) return start;
  Pose pose = start;
  pose.translation() += time * shift;
  if (angle == 0) return pose;
  // The pivot's place is kept by what the lever from it to the frame's origin turns by: (I - turn) lever, without the
  // cancellation of 1 - cos.
  const double turned = angle * time, sine = std::sin(turned), half = std::sin(turned / 2);
  const Vec2 lever = start.linear() * pivot;
  pose.linear() = Eigen::Rotation2Dd(turned).toRotationMatrix() * start.linear();
  pose.translation() += 2 * half * half * lever + sine * Vec2(lever.y(), -lever.x());
  return pose;
}

void checkMotion(const Motion& motion, const char* name) {
  const std::string prefix(name);
  checkPose(motion.start, (prefix + ".start").c_str());
  const auto require = [&](bool finite, const char* field) {
    if (!finite) detail::refuse(prefix + "." + field, "it is not finite");
  };
  require(motion.shift.allFinite(), "shift");
  require(std::isfinite(motion.angle), "angle");
  require(motion.pivot.allFinite(), "pivot");
}

}  // namespace tricover
