// SPDX-License-Identifier: BSD-3-Clause
#include "fcl_geometry.h"

namespace tricover::bench {

std::shared_ptr<Prism> makePrism(const Ring& convex_ring, double half_height) {
  const int n = static_cast<int>(convex_ring.size());
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const double z : {-half_height, half_height}) {
    for (const Vec2& v : convex_ring) vertices->emplace_back(v.x(), v.y(), z);
  }
  auto faces = std::make_shared<std::vector<int>>();
  faces->push_back(n);
  for (int i = n; i-- > 0;) faces->push_back(i);
  faces->push_back(n);
  for (int i = 0; i < n; ++i) faces->push_back(n + i);
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    faces->insert(faces->end(), {4, i, next, n + next, n + i});
  }
  auto prism = std::make_shared<Prism>(vertices, n + 2, faces);
  prism->computeLocalAABB();
  return prism;
}

std::shared_ptr<FlatMesh> makeFlatMesh(const std::vector<Triangle>& triangles) {
  auto mesh = std::make_shared<FlatMesh>();
  mesh->beginModel();
  for (const Triangle& t : triangles) {
    mesh->addTriangle({t[0].x(), t[0].y(), 0}, {t[1].x(), t[1].y(), 0}, {t[2].x(), t[2].y(), 0});
  }
  mesh->endModel();
  mesh->computeLocalAABB();
  return mesh;
}

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
