// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "core_scan.h"
#include "rivals/fcl_manager.h"
#include "tricover/scene.h"

/// One against many: each is made of bodies at rest and of the polygon that will ask, told the poses by prepare(), and
/// says by collide(i) whether the polygon meets any of them at the pose with index i. See rivals/ for the others.
namespace tricover::bench {

class ScanAsker {
 public:
  ScanAsker(const Placement& placement, Polygon moving) : scan_(placement), moving_(std::move(moving)) {}
  void prepare(std::vector<Pose> poses) { poses_ = std::move(poses); }
  bool collide(std::size_t i) const { return scan_.collides(moving_, poses_[i]); }

 private:
  CoreScan scan_;
  Polygon moving_;
  std::vector<Pose> poses_;
};

class SceneAsker {
 public:
  SceneAsker(const Placement& placement, Polygon moving) : moving_(std::move(moving)) {
    for (const Placed& placed : placement) scene_.add(placed.polygon, placed.pose);
  }
  void prepare(std::vector<Pose> poses) { poses_ = std::move(poses); }
  bool collide(std::size_t i) const { return scene_.collides(moving_, poses_[i]); }

 private:
  Scene scene_;
  Polygon moving_;
  std::vector<Pose> poses_;
};

/// Our shapes under one of FCL's managers, by unmodified fcl::collide.
class FclAsker {
 public:
  FclAsker(const Placement& placement, const Polygon& moving, bool array_tree);
  void prepare(const std::vector<Pose>& poses);
  bool collide(std::size_t i);

 private:
  static bool meet(fcl::CollisionObjectd* o1, fcl::CollisionObjectd* o2, void* data);

  std::vector<std::unique_ptr<fcl::CollisionObjectd>> still_;
  std::unique_ptr<fcl::CollisionObjectd> moving_;
  FclManager manager_;
  std::vector<fcl::Transform3d> transforms_;
};

}  // namespace tricover::bench
