// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/common/types.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "tricover/pose.h"

namespace tricover_fcl {

/// A pose in space that keeps the plane: what it does within the plane, and the height it lifts it to.
struct PlanarPose {
  tricover::Pose pose;
  double z;
  bool upside_down;  ///< local z points downwards
};

/// They throw std::invalid_argument, naming the pose and what is wrong with it: an entry that isn't finite, otherwise
/// that it leaves the plane, or that it isn't rigid.
[[noreturn]] void refuseTilt(const Eigen::Matrix4d& transform, const char* name);
[[noreturn]] void refuseDistortion(const Eigen::Matrix4d& transform, const char* name);

/// Column by column, and in place, as the kernel reads them: it would have to wait for entries written one by one.
inline void setColumns(tricover::Pose& pose, const double* x, const double* y, const double* translation) {
  auto& m = pose.matrix();
  std::memcpy(&m(0, 0), x, 2 * sizeof(double));
  std::memcpy(&m(0, 1), y, 2 * sizeof(double));
  std::memcpy(&m(0, 2), translation, 2 * sizeof(double));
  m.row(2) << 0, 0, 1;
}

/// Exact: the upper left 2 x 2 and the translation as they are stored.
template <typename S>
void setPlanarPart(tricover::Pose& pose, const fcl::Transform3<S>& transform) {
  const auto& m = transform.matrix();
  if constexpr (std::is_same_v<S, double>) {
    setColumns(pose, &m(0, 0), &m(0, 1), &m(0, 3));
  } else {
    const Eigen::Matrix<double, 2, 4> wide = m.template topRows<2>().template cast<double>();
    setColumns(pose, &wide(0, 0), &wide(0, 1), &wide(0, 3));
  }
}

/// That of a pose that keeps the plane. A tilt of rounding size is left out, as the kernel accepts as much in R.
/// What is wrong within the plane is left for the kernel to refuse.
template <typename S>
PlanarPose planarPose(const fcl::Transform3<S>& transform, const char* name) {
  const auto& m = transform.matrix();
  const auto at = [&](int row, int column) { return static_cast<double>(m(row, column)); };
  // Without branches (ints: compilers warn of bools that & joins), and so that NaN fails.
  const auto within = [](double entry, double bound) -> int { return std::abs(entry) <= bound; };
  constexpr double kTilt = tricover::kRigidTolerance;
  const int planar = within(at(2, 0), kTilt) & within(at(2, 1), kTilt) & within(at(0, 2), kTilt) &
                     within(at(1, 2), kTilt) & within(std::abs(at(2, 2)) - 1, kTilt) &
                     within(at(2, 3), std::numeric_limits<double>::max());
  if (planar == 0) refuseTilt(transform.matrix().template cast<double>(), name);
  PlanarPose planar_pose{tricover::Pose(), at(2, 3), at(2, 2) < 0};
  setPlanarPart(planar_pose.pose, transform);
  return planar_pose;
}

}  // namespace tricover_fcl
