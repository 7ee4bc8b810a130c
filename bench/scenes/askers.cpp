// SPDX-License-Identifier: BSD-3-Clause
#include "askers.h"

#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <map>

#include "rivals/fcl_geometry.h"
#include "tricover_fcl/tricover_fcl.h"

namespace tricover::bench {

FclAsker::FclAsker(const Placement& placement, const Polygon& moving, bool array_tree)
    : moving_(std::make_unique<fcl::CollisionObjectd>(std::make_shared<tricover_fcl::PolygonShaped>(moving))) {
  std::map<std::uint64_t, std::shared_ptr<tricover_fcl::PolygonShaped>> shapes;  // one for all copies of a polygon
  std::vector<fcl::CollisionObjectd*> all;
  for (const auto& [polygon, pose] : placement) {
    auto& shape = shapes[polygon.id()];
    if (!shape) shape = std::make_shared<tricover_fcl::PolygonShaped>(polygon);
    still_.push_back(std::make_unique<fcl::CollisionObjectd>(shape, toTransform(pose)));
    still_.back()->computeAABB();
    all.push_back(still_.back().get());
  }
  manager_ = makeFclManager(array_tree);
  manager_->registerObjects(all);
  manager_->setup();
}

void FclAsker::prepare(const std::vector<Pose>& poses) { transforms_ = toTransforms(poses); }

bool FclAsker::meet(fcl::CollisionObjectd* o1, fcl::CollisionObjectd* o2, void* data) {
  static const fcl::CollisionRequestd request;
  auto& result = *static_cast<fcl::CollisionResultd*>(data);
  return fcl::collide(o1, o2, request, result) > 0;
}

bool FclAsker::collide(std::size_t i) {
  moving_->setTransform(transforms_[i]);
  moving_->computeAABB();
  fcl::CollisionResultd result;
  manager_->collide(moving_.get(), &result, meet);
  return result.isCollision();
}

}  // namespace tricover::bench
