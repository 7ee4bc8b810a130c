// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/detail/gjk_solver_indep.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>
#include <fcl/narrowphase/detail/traversal/collision_node.h>
#include <fcl/narrowphase/detail/traversal/distance/mesh_distance_traversal_node.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "fcl_convex.h"
#include "fcl_geometry.h"

namespace tricover::bench {

/// FCL's hierarchies of the region's triangles, as FCL's own row runs them, without fcl::distance's dispatch. `Node` is
/// the traversal of meshes with that volume.
template <class Node, class Volume>
class FclBvhDistance {
 public:
  FclBvhDistance(const Polygon& fixed, const Polygon& moving, const Pose& fixed_pose = Pose::Identity())
      : fixed_(makeFlatMesh<Volume>(triangulate(fixed))),
        moving_(makeFlatMesh<Volume>(triangulate(moving))),
        fixed_transform_(toTransform(fixed_pose)) {}

  void prepare(const std::vector<Pose>& poses) { transforms_ = toTransforms(poses); }

  double value(std::size_t i) {
    result_.clear();
    Node node;
    initialize(node, *fixed_, fixed_transform_, *moving_, std::as_const(transforms_)[i], request_, result_);
    fcl::detail::distance(&node);
    return std::max(result_.min_distance, 0.0);
  }

 private:
  std::shared_ptr<const fcl::BVHModel<Volume>> fixed_, moving_;
  const fcl::Transform3d fixed_transform_;
  std::vector<fcl::Transform3d> transforms_;
  fcl::DistanceRequestd request_;
  fcl::DistanceResultd result_;
};

/// An OBBRSS tree's distances are its RSS's.
using FclRssDistance = FclBvhDistance<fcl::detail::MeshDistanceTraversalNodeRSSd, fcl::RSSd>;

/// FCL's solvers on two convex polygons; `coherent` starts from the last answer (GST_INDEP only).
template <class Solver>
class FclGjkDistance : public FclPieces {
 public:
  FclGjkDistance(const Polygon& fixed, const Polygon& moving, bool coherent) : FclPieces(fixed, moving) {
    solver_.enableCachedGuess(coherent);
  }

  double value(std::size_t i) {
    double distance = 0;
    anyPair(i, [&](const Prism& a, const Prism& b) {
      return !solver_.shapeDistance(a, identity_, b, transforms_[i], &distance);
    });
    return std::max(distance, 0.0);
  }

 private:
  Solver solver_;
};

}  // namespace tricover::bench
