// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/octree/octree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/ellipsoid.h>
#include <fcl/geometry/shape/halfspace.h>
#include <fcl/geometry/shape/plane.h>
#include <fcl/geometry/shape/sphere.h>

#include <memory>
#include <string>
#include <vector>

#include "ask.h"

namespace tricover_fcl::test {

template <typename S>
using Geometry = std::shared_ptr<fcl::CollisionGeometry<S>>;

/// A geometry, a pose for it, and where its shadow on the world's plane z = 0 ends along x on the line y = 0.
template <typename S>
struct Known {
  std::string name;
  Geometry<S> geometry;
  fcl::Transform3<S> pose;
  double right;
  bool grazing;  ///< it only touches the plane
};

template <typename S>
fcl::Transform3<S> placed(const fcl::Vector3<double>& at, const fcl::Matrix3<double>& rotation) {
  fcl::Transform3<S> transform = fcl::Transform3<S>::Identity();
  transform.linear() = rotation.cast<S>();
  transform.translation() = at.cast<S>();
  return transform;
}

inline fcl::Matrix3<double> turned(double angle, const fcl::Vector3<double>& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/// The surface of the box from -half to half.
template <typename BV, typename S = typename BV::S>
Geometry<S> boxMesh(const fcl::Vector3<S>& half) {
  std::vector<fcl::Vector3<S>> vertices;
  for (int i = 0; i < 8; ++i) {
    vertices.emplace_back(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(), i & 4 ? half.z() : -half.z());
  }
  const int quads[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
  std::vector<fcl::Triangle> triangles;
  for (const auto& q : quads) {
    const auto corner = [&q](int i) { return static_cast<std::size_t>(q[i]); };
    triangles.emplace_back(corner(0), corner(1), corner(2));
    triangles.emplace_back(corner(0), corner(2), corner(3));
  }
  auto mesh = std::make_shared<fcl::BVHModel<BV>>();
  mesh->beginModel();
  mesh->addSubModel(vertices, triangles);
  mesh->endModel();
  return mesh;
}

/// The tetrahedron of the origin and three points on the axes.
template <typename S>
Geometry<S> tetrahedron(S x, S y, S z) {
  const auto vertices = std::make_shared<const std::vector<fcl::Vector3<S>>>(std::vector<fcl::Vector3<S>>{
      fcl::Vector3<S>::Zero(), fcl::Vector3<S>(x, 0, 0), fcl::Vector3<S>(0, y, 0), fcl::Vector3<S>(0, 0, z)});
  const auto faces =
      std::make_shared<const std::vector<int>>(std::vector<int>{3, 0, 2, 1, 3, 0, 1, 3, 3, 0, 3, 2, 3, 1, 2, 3});
  return std::make_shared<fcl::Convex<S>>(vertices, 4, faces);
}

/// With the cells [1, 1.5]^2 x [0, 0.5] and [-3, -2.5]^2 x [0, 0.5] occupied and [2, 2.5] x [0, 0.5] x [0, 0.5] free.
template <typename S>
std::shared_ptr<fcl::OcTree<S>> octree() {
  const auto tree = std::make_shared<octomap::OcTree>(0.5);
  tree->updateNode(octomap::point3d(1.2f, 1.2f, 0.2f), true);
  tree->updateNode(octomap::point3d(-2.8f, -2.8f, 0.2f), true);
  tree->updateNode(octomap::point3d(2.2f, 0.2f, 0.2f), false);
  return std::make_shared<fcl::OcTree<S>>(std::shared_ptr<const octomap::OcTree>(tree));
}

/// A tip to the left, on the line y = 0, at x = 0.
template <typename S>
Shape<S> tip() {
  return shapeOf<S>(tricover::Polygon({{{0, 0}, {1, -0.1}, {1, 0.1}}}));
}

template <typename S>
fcl::Transform3<S> shifted(double x, double y, double z) {
  return placed<S>({x, y, z}, fcl::Matrix3<double>::Identity());
}

/// Every geometry that FCL knows, standing, lying or tilted.
template <typename S>
std::vector<Known<S>> knownGeometries();

extern template std::vector<Known<float>> knownGeometries();
extern template std::vector<Known<double>> knownGeometries();

}  // namespace tricover_fcl::test
