// SPDX-License-Identifier: BSD-3-Clause
#include "shape/planar_pose.h"

#include <cmath>
#include <sstream>
#include <string>

#include "shape/errors.h"

namespace tricover_fcl {
namespace {

const std::string kTolerance = "1e-6 (tricover::kRigidTolerance)";
static_assert(tricover::kRigidTolerance == 1e-6);

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

}  // namespace

void refuseTilt(const Eigen::Matrix4d& transform, const char* name) {
  requireFinite(transform, name);
  const auto inRow = [&](const Eigen::Vector3d& entries) {
    std::ostringstream text;
    text << "(" << entries.x() << ", " << entries.y() << ", " << entries.z() << ")";
    return text.str();
  };
  refuse(name,
         "it leaves the plane: the third row of linear() is " + inRow(transform.block<1, 3>(2, 0).transpose()) +
             " and its third column " + inRow(transform.block<3, 1>(0, 2)) +
             ", both must be (0, 0, 1) or (0, 0, -1) within " + kTolerance,
         "polygons meet polygons in the world's plane: turn them about z, or upside down");
}

void refuseDistortion(const Eigen::Matrix4d& transform, const char* name) {
  requireFinite(transform, name);
  refuse(name, "linear() is not rigid within " + kTolerance,
         "a pose only turns, mirrors and moves: scale the polygon's vertices or the geometry");
}

}  // namespace tricover_fcl
