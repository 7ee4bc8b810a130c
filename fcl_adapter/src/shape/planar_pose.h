// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/common/types.h>

#include <cmath>
#include <cstring>
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

/// The sum of what planarPose() compares with the tolerance one by one, so that it is at least each of them, also as
/// rounded; NaN if the height isn't finite.
template <typename S>
double tiltOf(const fcl::Transform3<S>& transform) {
  const auto& m = transform.matrix();
  const auto size = [&](int row, int column) { return std::abs(static_cast<double>(m(row, column))); };
  return ((size(2, 0) + size(2, 1)) + (size(0, 2) + size(1, 2))) +
         (std::abs(size(2, 2) - 1) + static_cast<double>(m(2, 3) - m(2, 3)));
}

/// Whether planarPose() and tricover::checkPose() let a pose pass, by one comparison: most that they do.
template <typename S>
bool isPlainlyPlanar(const fcl::Transform3<S>& transform) {
  const auto& m = transform.matrix();
  const auto at = [&](int row, int column) { return static_cast<double>(m(row, column)); };
  const auto dot = [&](int i, int j) { return at(0, i) * at(0, j) + at(1, i) * at(1, j); };
  const double shift = at(0, 3) + at(1, 3);
  const double defect = (std::abs(dot(0, 0) - 1) + std::abs(dot(1, 1) - 1)) + (std::abs(dot(0, 1)) + (shift - shift));
  return tiltOf(transform) + defect <= tricover::kRigidTolerance;
}

/// planarPose()'s conditions, one by one.
template <typename S>
void requirePlanar(const fcl::Transform3<S>& transform, const char* name) {
  const auto& m = transform.matrix();
  const auto within = [&](int row, int column) {
    return std::abs(static_cast<double>(m(row, column))) <= tricover::kRigidTolerance;
  };
  const bool upright = std::abs(std::abs(static_cast<double>(m(2, 2))) - 1) <= tricover::kRigidTolerance;
  if (!(within(2, 0) && within(2, 1) && within(0, 2) && within(1, 2) && upright && std::isfinite(m(2, 3))))
    refuseTilt(m.template cast<double>(), name);
}

/// That of a pose that keeps the plane. A tilt of rounding size is left out, as the kernel accepts as much in R.
/// What is wrong within the plane is left for the kernel to refuse.
template <typename S>
PlanarPose planarPose(const fcl::Transform3<S>& transform, const char* name) {
  const auto& m = transform.matrix();
  if (!(tiltOf(transform) <= tricover::kRigidTolerance)) requirePlanar(transform, name);
  PlanarPose planar_pose{tricover::Pose(), static_cast<double>(m(2, 3)), m(2, 2) < 0};
  setPlanarPart(planar_pose.pose, transform);
  return planar_pose;
}

}  // namespace tricover_fcl
