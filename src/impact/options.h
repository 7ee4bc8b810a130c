// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>

#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "tricover/time_of_impact.h"

namespace tricover::detail {

inline void checkOptions(const ImpactOptions& options) {
  requireFiniteNotNegative(options.time_error, "time_error");
  requireFiniteNotNegative(options.margin, "margin");
}

inline void requireFinite(double time, const char* field) {
  if (!std::isfinite(time)) refuse(field, "it is not finite", "give a finite time");
}

/// Motion::between() of two poses that errors call by these names.
Motion motionBetween(const Pose& start, const std::string& start_name, const Pose& end, const std::string& end_name,
                     const Vec2& pivot);

/// Of a motion's numbers, its start's aside: NaN or infinite where one of them is, or a sum overflows.
inline double sumOf(const Motion& m) {
  const Double2 ways =
      (load2(m.shift.data()) + load2(m.pivot.data())) + (load2(m.shift_2.data()) + load2(m.shift_3.data()));
  return (ways[0] + ways[1]) + (m.angle + m.angle_2 + m.angle_3);
}

/// Whether checkMotion() lets a motion pass, as most do.
inline bool isPlain(const Motion& motion) { return isPlainlyRigid(motion.start) && 0 * sumOf(motion) == 0; }

/// checkMotion() of both, which most pass together.
inline void checkMotions(const Motion& motion_a, const Motion& motion_b) {
  if (defectOf(motion_a.start, motion_b.start) <= kRigidTolerance && 0 * (sumOf(motion_a) + sumOf(motion_b)) == 0)
    return;
  checkMotion(motion_a, "motion_a");
  checkMotion(motion_b, "motion_b");
}

}  // namespace tricover::detail
