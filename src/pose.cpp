// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/pose.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace tricover {

void checkPose(const Pose& pose, const char* name) {
  const auto& m = pose.matrix();
  const double xx = m(0, 0) * m(0, 0) + m(1, 0) * m(1, 0) - 1;
  const double yy = m(0, 1) * m(0, 1) + m(1, 1) * m(1, 1) - 1;
  const double xy = m(0, 0) * m(0, 1) + m(1, 0) * m(1, 1);
  // Negated, so that NaN fails.
  if (!(std::abs(xx) <= kRigidTolerance && std::abs(yy) <= kRigidTolerance && std::abs(xy) <= kRigidTolerance))
    throw std::invalid_argument(std::string(name) + ": its linear part is not rigid within 1e-6");
  if (!std::isfinite(m(0, 2)) || !std::isfinite(m(1, 2)))
    throw std::invalid_argument(std::string(name) + ": its translation is not finite");
}

}  // namespace tricover
