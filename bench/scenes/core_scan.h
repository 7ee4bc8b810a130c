// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "placed.h"
#include "tricover/collide.h"

namespace tricover::bench {

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
