// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "tricover/time_of_impact.h"

namespace tricover::detail {

inline void checkOptions(const ImpactOptions& options) {
  requireFiniteNotNegative(options.time_error, "time_error");
  requireFiniteNotNegative(options.margin, "margin");
}

/// checkMotion() of both, which most pass together: what isn't finite, or a sum that overflows, leaves NaN.
inline void checkMotions(const Motion& motion_a, const Motion& motion_b) {
  const auto sum = [](const Motion& m) {
    const Double2 ways =
        (load2(m.shift.data()) + load2(m.pivot.data())) + (load2(m.shift_2.data()) + load2(m.shift_3.data()));
    return (ways[0] + ways[1]) + (m.angle + m.angle_2 + m.angle_3);
  };
  if (defectOf(motion_a.start, motion_b.start) <= kRigidTolerance && 0 * (sum(motion_a) + sum(motion_b)) == 0) return;
  checkMotion(motion_a, "motion_a");
  checkMotion(motion_b, "motion_b");
}

}  // namespace tricover::detail
