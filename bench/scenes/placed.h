// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <utility>
#include <vector>

#include "tricover/collide.h"
#include "tricover/polygon.h"
#include "tricover/pose.h"
#include "tricover/scene.h"

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

/// The polygon with its vertices where `map` takes them.
template <class Map>
Polygon mapped(const Polygon& polygon, Map map) {
  std::vector<Ring> rings = polygon.rings();
  for (Ring& ring : rings)
    for (Vec2& v : ring) v = map(v);
  return Polygon(std::move(rings), polygon.fillRule());
}

/// Where the pose takes them, rounded: for rivals that know no poses.
inline Polygon posed(const Polygon& polygon, const Pose& pose) {
  return mapped(polygon, [&](const Vec2& v) { return pose * v; });
}

inline Scene sceneOf(const Placement& placement) {
  Scene scene;
  for (const Placed& placed : placement) scene.add(placed.polygon, placed.pose);
  return scene;
}

/// The core without a scene: all boxes are compared with the asking polygon's, and collide() decides where they meet.
class CoreScan {
 public:
  CoreScan() = default;
  explicit CoreScan(const Placement& placement) {
    for (const Placed& placed : placement) add(placed);
  }

  void add(const Placed& placed) {
    boxes_.push_back(boundsOf(placed.polygon, placed.pose));
    placement_.push_back(placed);
  }

  bool collides(const Polygon& polygon, const Pose& pose) const {
    const Eigen::AlignedBox2d box = boundsOf(polygon, pose);
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (!box.intersects(boxes_[i])) continue;
      if (collide(placement_[i].polygon, placement_[i].pose, polygon, pose)) return true;
    }
    return false;
  }

 private:
  std::vector<Eigen::AlignedBox2d> boxes_;
  Placement placement_;
};

}  // namespace tricover::bench
