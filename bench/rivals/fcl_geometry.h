// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/bvh/BVH_model.h>

#include <memory>
#include <vector>

#include "convex_pieces.h"

/// The rivals' shapes and frames.
namespace tricover::bench {

using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;

template <class Volume = fcl::OBBRSSd>
std::shared_ptr<fcl::BVHModel<Volume>> makeFlatMesh(const std::vector<Triangle>& triangles) {
  auto mesh = std::make_shared<fcl::BVHModel<Volume>>();
  mesh->beginModel();
  for (const Triangle& t : triangles)
    mesh->addTriangle({t[0].x(), t[0].y(), 0}, {t[1].x(), t[1].y(), 0}, {t[2].x(), t[2].y(), 0});
  mesh->endModel();
  mesh->computeLocalAABB();
  return mesh;
}

inline fcl::Transform3d toTransform(const Pose& pose) {
  fcl::Transform3d transform = fcl::Transform3d::Identity();
  transform.linear().topLeftCorner<2, 2>() = pose.linear();
  transform.translation().head<2>() = pose.translation();
  return transform;
}

inline std::vector<fcl::Transform3d> toTransforms(const std::vector<Pose>& poses) {
  std::vector<fcl::Transform3d> transforms;
  transforms.reserve(poses.size());
  for (const Pose& pose : poses) transforms.push_back(toTransform(pose));
  return transforms;
}

/// Where a pair of FCL's is asked: converted before it is timed.
class FclPosed {
 public:
  explicit FclPosed(const Pose& fixed_pose = Pose::Identity()) : fixed_transform_(toTransform(fixed_pose)) {}
  void prepare(const std::vector<Pose>& poses) { transforms_ = toTransforms(poses); }
  void prepare(const std::vector<fcl::Transform3d>& transforms) { transforms_ = transforms; }

 protected:
  const fcl::Transform3d fixed_transform_;
  std::vector<fcl::Transform3d> transforms_;
};

}  // namespace tricover::bench
