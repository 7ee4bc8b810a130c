// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <utility>
#include <vector>

#include "tricover/polygon.h"
#include "tricover/pose.h"

namespace tricover::bench {

/// A polygon at rest.
struct Placed {
  Polygon polygon;
  Pose pose;
};

/// Many of them: a layout, a map.
using Placement = std::vector<Placed>;

/// From and to.
using Ray = std::pair<Vec2, Vec2>;

/// Around the posed vertices, a billionth wider than they: more than rounding takes away.
inline Eigen::AlignedBox2d boundsOf(const Polygon& polygon, const Pose& pose) {
  Eigen::AlignedBox2d box;
  for (const Ring& ring : polygon.rings()) {
    for (const Vec2& v : ring) box.extend(Vec2(pose * v));
  }
  const double slack = 1e-9 * (box.min().cwiseAbs().maxCoeff() + box.max().cwiseAbs().maxCoeff());
  return {box.min().array() - slack, box.max().array() + slack};
}

inline Eigen::AlignedBox2d boundsOf(const Placement& placement) {
  Eigen::AlignedBox2d box;
  for (const Placed& placed : placement) box.extend(boundsOf(placed.polygon, placed.pose));
  return box;
}

inline std::size_t vertexCount(const Placement& placement) {
  std::size_t count = 0;
  for (const Placed& placed : placement) count += placed.polygon.vertexCount();
  return count;
}

inline Pose poseAt(const Vec2& position, double angle) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Rotation2Dd(angle).toRotationMatrix();
  pose.translation() = position;
  return pose;
}

/// The polygon with its vertices where the pose takes them, rounded: for rivals that know no poses.
inline Polygon posed(const Polygon& polygon, const Pose& pose) {
  std::vector<Ring> rings = polygon.rings();
  for (Ring& ring : rings) {
    for (Vec2& v : ring) v = pose * v;
  }
  return Polygon(std::move(rings), polygon.fillRule());
}

}  // namespace tricover::bench
