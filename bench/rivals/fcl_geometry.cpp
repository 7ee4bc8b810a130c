// SPDX-License-Identifier: BSD-3-Clause
#include "fcl_geometry.h"

namespace tricover::bench {

fcl::Transform3d toTransform(const Pose& pose) {
  fcl::Transform3d transform = fcl::Transform3d::Identity();
  transform.linear().topLeftCorner<2, 2>() = pose.linear();
  transform.translation().head<2>() = pose.translation();
  return transform;
}

std::vector<fcl::Transform3d> toTransforms(const std::vector<Pose>& poses) {
  std::vector<fcl::Transform3d> transforms;
  transforms.reserve(poses.size());
  for (const Pose& pose : poses) transforms.push_back(toTransform(pose));
  return transforms;
}

}  // namespace tricover::bench
