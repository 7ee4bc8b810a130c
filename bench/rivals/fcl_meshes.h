// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/detail/traversal/collision/mesh_collision_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/collision_node.h>
#include <fcl/narrowphase/detail/traversal/distance/mesh_distance_traversal_node.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "fcl_geometry.h"

namespace tricover::bench {

/// FCL's hierarchies of the region's triangles, as FCL's own rows run them, without the dispatch of fcl::collide and
/// fcl::distance. `Node` is the traversal of meshes with that volume.
template <class Volume, class Node, class Request, class Outcome>
class FclMeshes : public FclPosed {
 public:
  FclMeshes(const std::vector<Triangle>& fixed, const std::vector<Triangle>& moving,
            const Pose& fixed_pose = Pose::Identity())
      : FclPosed(fixed_pose), fixed_(makeFlatMesh<Volume>(fixed)), moving_(makeFlatMesh<Volume>(moving)) {}
  FclMeshes(const Polygon& fixed, const Polygon& moving, const Pose& fixed_pose = Pose::Identity())
      : FclMeshes(triangulate(fixed), triangulate(moving), fixed_pose) {}

  bool collide(std::size_t i) {
    Node node;
    start(node, i);
    fcl::detail::collide(&node);
    return result_.isCollision();
  }
  double value(std::size_t i) {
    Node node;
    start(node, i);
    fcl::detail::distance(&node);
    return std::max(result_.min_distance, 0.0);
  }

 private:
  void start(Node& node, std::size_t i) {
    result_.clear();
    initialize(node, *fixed_, fixed_transform_, *moving_, std::as_const(transforms_)[i], request_, result_);
  }

  std::shared_ptr<const fcl::BVHModel<Volume>> fixed_, moving_;
  Request request_;
  Outcome result_;
};

using FclBvh = FclMeshes<fcl::OBBRSSd, fcl::detail::MeshCollisionTraversalNodeOBBRSS<double>, fcl::CollisionRequestd,
                         fcl::CollisionResultd>;
/// An OBBRSS tree's distances are its RSS's.
using FclRssDistance =
    FclMeshes<fcl::RSSd, fcl::detail::MeshDistanceTraversalNodeRSSd, fcl::DistanceRequestd, fcl::DistanceResultd>;

}  // namespace tricover::bench
