// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/collision.h>

#include <memory>
#include <utility>
#include <vector>

#include "fcl_geometry.h"

namespace tricover::bench {

/// Two objects asked by the unmodified fcl::collide, as its users do.
class FclCall {
 public:
  using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;

  FclCall(Geometry fixed, Geometry moving) : fixed_(std::move(fixed)), moving_(std::move(moving)) {}

  void prepare(const std::vector<Pose>& poses) { transforms_ = toTransforms(poses); }

  bool collide(std::size_t i) {
    result_.clear();
    moving_.setTransform(transforms_[i]);
    return fcl::collide(&fixed_, &moving_, request_, result_) > 0;
  }

 private:
  fcl::CollisionObjectd fixed_, moving_;
  std::vector<fcl::Transform3d> transforms_;
  fcl::CollisionRequestd request_;
  fcl::CollisionResultd result_;
};

}  // namespace tricover::bench
