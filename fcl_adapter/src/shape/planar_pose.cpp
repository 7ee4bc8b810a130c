// SPDX-License-Identifier: BSD-3-Clause
#include "shape/planar_pose.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "shape/errors.h"

namespace tricover_fcl {
namespace {

void requireFinite(const Eigen::Matrix4d& transform, const char* name) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      if (std::isfinite(transform(row, column))) continue;
      const std::string place = std::to_string(row);
      refuse(name, (column == 3 ? "translation(" + place : "linear(" + place + ", " + std::to_string(column)) +
                       ") is not finite");
    }
  }
}

[[noreturn]] void refuseTilt(const Eigen::Matrix4d& transform, const char* name) {
  const auto text = [](const Eigen::Vector3d& entries) {
    std::ostringstream row;
    row << "(" << entries.x() << ", " << entries.y() << ", " << entries.z() << ")";
    return row.str();
  };
  refuse(name,
         "it leaves the plane: the third row of linear() is " + text(transform.block<1, 3>(2, 0).transpose()) +
             " and its third column " + text(transform.block<3, 1>(0, 2)) +
             ", both must be (0, 0, 1) or (0, 0, -1) within 1e-6",
         "polygons meet polygons in the world's plane: turn them about z, or upside down");
}
static_assert(kTiltTolerance == 1e-6);

}  // namespace

void refusePose(const Eigen::Matrix4d& transform, bool in_plane, const char* name) {
  requireFinite(transform, name);
  // What only scales keeps the plane.
  const Eigen::Matrix3d r = transform.topLeftCorner<3, 3>();
  const double out = std::max(r.topRightCorner<2, 1>().lpNorm<Eigen::Infinity>(),
                              r.bottomLeftCorner<1, 2>().lpNorm<Eigen::Infinity>());
  const double off = (r.transpose() * r - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  const double size = off <= tricover::kRigidTolerance ? 1 : std::max(1.0, std::abs(r(2, 2)));
  if (in_plane && !(out <= kTiltTolerance * size)) refuseTilt(transform, name);
  refuse(
      name, tricover::detail::offRigid(off),
      "a pose only turns, mirrors and moves: Eigen::Affine3d(pose).rotation() is the turn of one that doesn't mirror");
}

}  // namespace tricover_fcl
