// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/common/types.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "numbers/rigidity.h"
#include "tricover/pose.h"

namespace tricover_fcl {

/// A pose in space that keeps the plane: what it does within the plane, and the height it lifts it to.
struct PlanarPose {
  tricover::Pose pose;
  double z;
  bool upside_down;  ///< local z points downwards
};

/// How far the entries of R that lead out of the plane may be from 0. It is less than tricover::kRigidTolerance,
/// because queries about two polygons leave such a tilt out, whereas R's part in the plane is taken as written.
constexpr double kTiltTolerance = 1e-6;

/// Throws std::invalid_argument, naming the pose and what is wrong with it: an entry that isn't finite; otherwise that
/// it leaves the plane, where it has to keep it; otherwise that it isn't rigid.
[[noreturn]] void refusePose(const Eigen::Matrix4d& transform, bool in_plane, const char* name);

/// The largest entry of R^T R - I, in space; NaN for a pose that isn't finite.
template <typename S>
double defectOf(const fcl::Transform3<S>& transform) {
  const auto& m = transform.matrix();
  const auto at = [&](int row, int column) { return static_cast<double>(m(row, column)); };
  double largest = 0, sum = at(0, 3) + at(1, 3) + at(2, 3);
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      const double entry = std::abs(at(0, i) * at(0, j) + at(1, i) * at(1, j) + at(2, i) * at(2, j) - (i == j ? 1 : 0));
      largest = std::max(largest, entry);
      sum += entry;
    }
  }
  return largest + (sum - sum);
}

/// Any pose in space.
template <typename S>
void requireRigid(const fcl::Transform3<S>& transform, const char* name) {
  if (!(defectOf(transform) <= tricover::kRigidTolerance))
    refusePose(transform.matrix().template cast<double>(), false, name);
}

/// Column by column, and in place, as the kernel reads them: it would have to wait for entries written one by one. A
/// pose that was made has its last row already.
inline void setColumns(tricover::Pose& pose, const double* x, const double* y, const double* translation) {
  auto& m = pose.matrix();
  std::memcpy(&m(0, 0), x, 2 * sizeof(double));
  std::memcpy(&m(0, 1), y, 2 * sizeof(double));
  std::memcpy(&m(0, 2), translation, 2 * sizeof(double));
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

/// The sum of the entries that lead out of the plane, and of what the one along z misses 1 by; NaN if the height isn't
/// finite.
template <typename S>
double tiltOf(const fcl::Transform3<S>& transform) {
  const auto& m = transform.matrix();
  const auto size = [&](int row, int column) { return std::abs(static_cast<double>(m(row, column))); };
  return ((size(2, 0) + size(2, 1)) + (size(0, 2) + size(1, 2))) +
         (std::abs(size(2, 2) - 1) + static_cast<double>(m(2, 3) - m(2, 3)));
}

/// Whether a pose keeps the plane: entry by entry, what tiltOf() tells of most poses at once.
template <typename S>
bool keepsPlane(const fcl::Transform3<S>& transform) {
  if (tiltOf(transform) <= kTiltTolerance) return true;
  const auto& m = transform.matrix();
  const auto size = [&](int row, int column) { return std::abs(static_cast<double>(m(row, column))); };
  const bool level = size(2, 0) <= kTiltTolerance && size(2, 1) <= kTiltTolerance && size(0, 2) <= kTiltTolerance &&
                     size(1, 2) <= kTiltTolerance;
  return level && std::abs(size(2, 2) - 1) <= tricover::kRigidTolerance && std::isfinite(m(2, 3));
}

/// What is wrong within the plane is left for the kernel to refuse.
template <typename S>
void requirePlanar(const fcl::Transform3<S>& transform, const char* name) {
  if (!keepsPlane(transform)) refusePose(transform.matrix().template cast<double>(), true, name);
}

/// The same for two poses, by one comparison for most of them.
template <typename S>
void requirePlanar(const fcl::Transform3<S>& tf1, const fcl::Transform3<S>& tf2) {
  if (tiltOf(tf1) + tiltOf(tf2) <= kTiltTolerance) return;
  requirePlanar(tf1, "pose_a");
  requirePlanar(tf2, "pose_b");
}

/// That of a pose that keeps the plane.
template <typename S>
PlanarPose planarPose(const fcl::Transform3<S>& transform, const char* name) {
  requirePlanar(transform, name);
  const auto& m = transform.matrix();
  PlanarPose planar_pose{tricover::Pose(), static_cast<double>(m(2, 3)), m(2, 2) < 0};
  setPlanarPart(planar_pose.pose, transform);
  return planar_pose;
}

}  // namespace tricover_fcl
