// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/detail/traversal/collision/mesh_collision_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/collision_node.h>

#include <memory>
#include <utility>
#include <vector>

#include "fcl_geometry.h"

namespace tricover::bench {

/// FCL's OBBRSS hierarchies of the region's triangles, as FCL's own row runs them, without fcl::collide's dispatch.
class FclBvh {
 public:
  FclBvh(const Polygon& fixed, const Polygon& moving, const Pose& fixed_pose = Pose::Identity())
      : FclBvh(triangulate(fixed), triangulate(moving), fixed_pose) {}
  FclBvh(const std::vector<Triangle>& fixed, const std::vector<Triangle>& moving,
         const Pose& fixed_pose = Pose::Identity())
      : fixed_(makeFlatMesh(fixed)), moving_(makeFlatMesh(moving)), fixed_transform_(toTransform(fixed_pose)) {}

  void prepare(const std::vector<Pose>& poses) { transforms_ = toTransforms(poses); }

  bool collide(std::size_t i) {
    result_.clear();
    fcl::detail::MeshCollisionTraversalNodeOBBRSS<double> node;
    initialize(node, *fixed_, fixed_transform_, *moving_, std::as_const(transforms_)[i], request_, result_);
    fcl::detail::collide(&node);
    return result_.isCollision();
  }

 private:
  std::shared_ptr<const fcl::BVHModel<fcl::OBBRSSd>> fixed_, moving_;
  const fcl::Transform3d fixed_transform_;
  std::vector<fcl::Transform3d> transforms_;
  fcl::CollisionRequestd request_;
  fcl::CollisionResultd result_;
};

}  // namespace tricover::bench
