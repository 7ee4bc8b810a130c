// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/common/types.h>

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

#include "tricover/pose.h"

namespace tricover_fcl {

/// A pose in space that keeps the plane: what it does within the plane, and the height it lifts it to.
struct PlanarPose {
  tricover::Pose pose;
  double z;
};

/// Exact: the upper left 2 x 2 and the translation as they are stored. A tilt of rounding size is left out, as the
/// kernel accepts as much in R. What is wrong within the plane is left for the kernel to refuse.
template <typename S>
PlanarPose planarPose(const fcl::Transform3<S>& transform, const char* name) {
  const auto m = transform.matrix().template topRows<3>().template cast<double>().eval();
  // Written so that NaN fails.
  const auto negligible = [](double entry) { return std::abs(entry) <= tricover::kRigidTolerance; };
  if (!(negligible(m(2, 0)) && negligible(m(2, 1)) && negligible(m(0, 2)) && negligible(m(1, 2)) &&
        negligible(std::abs(m(2, 2)) - 1))) {
    std::ostringstream text;
    text << "tricover: " << name << " leaves the plane: the third row of R is (" << m(2, 0) << ", " << m(2, 1) << ", "
         << m(2, 2) << "), its third column (" << m(0, 2) << ", " << m(1, 2) << ", " << m(2, 2)
         << "); both must be (0, 0, 1) or (0, 0, -1)";
    throw std::invalid_argument(text.str());
  }
  if (!std::isfinite(m(2, 3))) throw std::invalid_argument(std::string("tricover: ") + name + ": z is not finite");

  PlanarPose planar;
  planar.pose.linear() = m.template topLeftCorner<2, 2>();
  planar.pose.translation() << m(0, 3), m(1, 3);
  planar.pose.makeAffine();
  planar.z = m(2, 3);
  return planar;
}

}  // namespace tricover_fcl
