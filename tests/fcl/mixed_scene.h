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

template <typename S = double>
fcl::Transform3<S> placed(const Vec3& at, const fcl::Matrix3<double>& rotation) {
  fcl::Transform3<S> transform = fcl::Transform3<S>::Identity();
  transform.linear() = rotation.cast<S>();
  transform.translation() = at.cast<S>();
  return transform;
}

inline fcl::Matrix3<double> turned(double angle, const Vec3& axis) {
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

/// The tetrahedron of these corners, of which the first three are seen clockwise from the fourth.
template <typename S>
Geometry<S> tetrahedron(const std::vector<fcl::Vector3<S>>& corners) {
  const auto faces =
      std::make_shared<const std::vector<int>>(std::vector<int>{3, 0, 2, 1, 3, 0, 1, 3, 3, 0, 3, 2, 3, 1, 2, 3});
  return std::make_shared<fcl::Convex<S>>(std::make_shared<const std::vector<fcl::Vector3<S>>>(corners), 4, faces);
}

/// Of the origin and three points on the axes.
template <typename S>
Geometry<S> tetrahedron(S x, S y, S z) {
  return tetrahedron<S>({fcl::Vector3<S>::Zero(), {x, 0, 0}, {0, y, 0}, {0, 0, z}});
}

/// Of cells of this size, by points in them.
template <typename S = double>
std::shared_ptr<fcl::OcTree<S>> octreeOf(double cell, const std::vector<fcl::Vector3f>& occupied,
                                         const std::vector<fcl::Vector3f>& free = {}) {
  const auto tree = std::make_shared<octomap::OcTree>(cell);
  for (const fcl::Vector3f& p : occupied) tree->updateNode(octomap::point3d(p.x(), p.y(), p.z()), true);
  for (const fcl::Vector3f& p : free) tree->updateNode(octomap::point3d(p.x(), p.y(), p.z()), false);
  return std::make_shared<fcl::OcTree<S>>(std::shared_ptr<const octomap::OcTree>(tree));
}

/// With the cells [1, 1.5]^2 x [0, 0.5] and [-3, -2.5]^2 x [0, 0.5] occupied and [2, 2.5] x [0, 0.5] x [0, 0.5] free.
template <typename S = double>
std::shared_ptr<fcl::OcTree<S>> octree() {
  return octreeOf<S>(0.5, {{1.2f, 1.2f, 0.2f}, {-2.8f, -2.8f, 0.2f}}, {{2.2f, 0.2f, 0.2f}});
}

/// A tip to the left, on the line y = 0, at x = 0.
template <typename S = double>
Shape<S> tip(const PolygonOptions& options = {}) {
  return shapeOf<S>(Polygon({{{0, 0}, {1, -0.1}, {1, 0.1}}}), options);
}

template <typename S = double>
fcl::Transform3<S> shifted(double x, double y, double z) {
  return placed<S>({x, y, z}, fcl::Matrix3<double>::Identity());
}

inline Vec3 anyPoint(Random& random, double reach) {
  const double x = random.real(-reach, reach), y = random.real(-reach, reach);
  return {x, y, random.real(-reach, reach)};
}

/// Anywhere in space, turned anyhow.
inline Transform anywhere(Random& random, double reach) {
  const Vec3 axis = anyPoint(random, 1), at = anyPoint(random, reach);
  return placed(at, turned(random.real(0, 6), axis));
}

/// With its axis in the plane, which is that of a lying capsule.
inline Transform lying(const Vec2& axis, const Vec3& at) {
  fcl::Matrix3d rotation;
  rotation << -axis.y(), 0, axis.x(), axis.x(), 0, axis.y(), 0, 1, 0;
  return placed(at, rotation);
}

/// One of FCL's solids, by a number from 0 to 6, with lengths that are drawn.
template <typename S, typename Length>
Geometry<S> solid(int kind, const Length& length) {
  const S a = static_cast<S>(length()), b = static_cast<S>(length()), c = static_cast<S>(length());
  switch (kind) {
    case 0:
      return std::make_shared<fcl::Box<S>>(a, b, c);
    case 1:
      return std::make_shared<fcl::Sphere<S>>(a);
    case 2:
      return std::make_shared<fcl::Ellipsoid<S>>(a, b, c);
    case 3:
      return std::make_shared<fcl::Capsule<S>>(a, b);
    case 4:
      return std::make_shared<fcl::Cylinder<S>>(a, b);
    case 5:
      return std::make_shared<fcl::Cone<S>>(a, b);
    default:
      return tetrahedron<S>(a, b, c);
  }
}

/// Planes and halfspaces go everywhere.
template <typename S>
bool isEndless(const fcl::CollisionGeometry<S>& geometry) {
  return geometry.getNodeType() == fcl::GEOM_PLANE || geometry.getNodeType() == fcl::GEOM_HALFSPACE;
}

/// Every geometry that FCL knows, standing, lying or tilted.
template <typename S>
std::vector<Known<S>> knownGeometries();

extern template std::vector<Known<float>> knownGeometries();
extern template std::vector<Known<double>> knownGeometries();

}  // namespace tricover_fcl::test
