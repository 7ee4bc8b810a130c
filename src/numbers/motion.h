// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>

#include "numbers/errors.h"
#include "tricover/motion.h"

namespace tricover::detail {

inline void requireFinite(double time, const char* field) {
  if (!std::isfinite(time)) refuse(field, "it is not finite", "give a finite time");
}

/// Motion::between() of two poses that errors call by these names.
Motion motionBetween(const Pose& start, const std::string& start_name, const Pose& end, const std::string& end_name,
                     const Vec2& pivot);

/// Where a body is whose pivot and heading these are.
inline Pose poseOfPivot(const Vec2& position, double angle, const Vec2& pivot) {
  Pose pose = poseAt(0, 0, angle);
  pose.translation() = position - pose.linear() * pivot;
  return pose;
}

inline void checkMotions(const Motion& motion_a, const Motion& motion_b) {
  checkMotion(motion_a, "motion_a");
  checkMotion(motion_b, "motion_b");
}

}  // namespace tricover::detail
