// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "fcl_geometry.h"

namespace tricover::bench {

/// A geometry of no known type, whose collision function, once registered, answers "free" and does nothing else: what
/// fcl::collide costs whoever registers a function.
std::shared_ptr<fcl::CollisionGeometryd> emptyGeometry();

/// Two objects asked by the unmodified fcl::collide and fcl::distance, as their users do.
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
  double value(std::size_t i) {
    distance_result_.clear();
    moving_.setTransform(transforms_[i]);
    return std::max(fcl::distance(&fixed_, &moving_, distance_request_, distance_result_), 0.0);
  }

 private:
  fcl::CollisionObjectd fixed_, moving_;
  std::vector<fcl::Transform3d> transforms_;
  fcl::CollisionRequestd request_;
  fcl::CollisionResultd result_;
  fcl::DistanceRequestd distance_request_;
  fcl::DistanceResultd distance_result_;
};

}  // namespace tricover::bench
