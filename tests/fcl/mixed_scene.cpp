// SPDX-License-Identifier: BSD-3-Clause
#include "mixed_scene.h"

#include <cmath>

namespace tricover_fcl::test {

template <typename S>
std::vector<Known<S>> knownGeometries() {
  const fcl::Matrix3<double> upright = fcl::Matrix3<double>::Identity();
  const fcl::Matrix3<double> lying = turned(M_PI / 2, Vec3::UnitY());    // local z along x
  const fcl::Matrix3<double> leaning = turned(M_PI / 4, Vec3::UnitY());  // local z towards +x
  const double root = std::sqrt(2.0);
  std::vector<Known<S>> known;
  const auto add = [&known](const std::string& name, const Geometry<S>& geometry, const Vec3& at,
                            const fcl::Matrix3<double>& rotation, double right, bool grazing = false) {
    known.push_back({name, geometry, placed<S>(at, rotation), right, grazing});
  };

  const auto box = std::make_shared<fcl::Box<S>>(S(2), S(3), S(4));
  add("box", box, {0, 0, 1}, upright, 1);
  add("box standing on the plane", box, {0, 0, 2}, upright, 1, true);
  add("box leaning", box, {0, 0, 0}, leaning, root);
  add("box lying", box, {0, 0, 0.5}, lying, 2);
  const auto sphere = std::make_shared<fcl::Sphere<S>>(S(2));
  add("sphere", sphere, {0, 0, 0}, upright, 2);
  add("sphere above", sphere, {0, 0, 1.5}, leaning, std::sqrt(4 - 2.25));
  add("sphere below", sphere, {0, 0, -1.99}, upright, std::sqrt(4 - 1.99 * 1.99));
  const auto ellipsoid = std::make_shared<fcl::Ellipsoid<S>>(S(1), S(2), S(3));
  add("ellipsoid", ellipsoid, {0, 0, 1}, upright, std::sqrt(1 - 1.0 / 9));
  add("ellipsoid lying", ellipsoid, {0, 0, 0.5}, lying, 3 * std::sqrt(1 - 0.25));
  // x'^2 + z'^2 / 9 = 1 with x' = -z' = x / sqrt(2) on the plane.
  add("ellipsoid leaning", ellipsoid, {0, 0, 0}, leaning, std::sqrt(2 / (1 + 1.0 / 9)));
  const auto capsule = std::make_shared<fcl::Capsule<S>>(S(1), S(2));
  add("capsule's middle", capsule, {0, 0, 0.5}, upright, 1);
  add("capsule's cap", capsule, {0, 0, -1.5}, upright, std::sqrt(0.75));
  add("capsule lying", capsule, {0, 0, 0.6}, lying, 1 + 0.8);
  const auto cone = std::make_shared<fcl::Cone<S>>(S(2), S(4));
  add("cone", cone, {0, 0, 1}, upright, 2 * 0.75);
  add("cone's tip", cone, {0, 0, -2}, upright, 0, true);
  add("cone's base", cone, {0, 0, 2}, upright, 2, true);
  add("cone lying, its tip to the right", cone, {0, 0, 0}, lying, 2);
  add("cone lying, cut beside its axis", cone, {0, 0, 1}, lying, 0);  // a hyperbola, at half the height
  const auto cylinder = std::make_shared<fcl::Cylinder<S>>(S(1.5), S(2));
  add("cylinder", cylinder, {0, 0, 0.3}, upright, 1.5);
  add("cylinder standing on the plane", cylinder, {0, 0, 1}, upright, 1.5, true);
  add("cylinder lying", cylinder, {0, 0, 0.9}, lying, 1);
  add("cylinder leaning", std::make_shared<fcl::Cylinder<S>>(S(1), S(100)), {0, 0, 0}, leaning, root);
  add("convex", tetrahedron<S>(4, 4, 4), {0, 0, -1}, upright, 3);
  add("convex on its face", tetrahedron<S>(4, 4, 4), {0, 0, 0}, upright, 4, true);
  add("convex on its tip", tetrahedron<S>(4, 4, 4), {0, 0, -4}, upright, 0, true);
  add("plane", std::make_shared<fcl::Plane<S>>(S(1), S(0), S(0), S(0.75)), {0, 0, 0}, upright, 0.75);
  add("plane leaning", std::make_shared<fcl::Plane<S>>(S(1), S(0), S(0), S(0)), {1, 0, -1}, leaning, 2);
  add("halfspace", std::make_shared<fcl::Halfspace<S>>(S(1), S(0), S(0), S(0.75)), {0, 0, 5}, upright, 0.75);
  add("halfspace leaning", std::make_shared<fcl::Halfspace<S>>(S(1), S(0), S(0), S(0)), {1, 0, -1}, leaning, 2);
  const fcl::Vector3<S> half(1, 1.5, 2);
  add("AABB mesh", boxMesh<fcl::AABB<S>>(half), {0, 0, 1}, upright, 1);
  add("OBB mesh", boxMesh<fcl::OBB<S>>(half), {0, 0, 0}, leaning, root);
  add("RSS mesh", boxMesh<fcl::RSS<S>>(half), {0, 0, 0.5}, lying, 2);
  add("kIOS mesh", boxMesh<fcl::kIOS<S>>(half), {0, 0, 2}, upright, 1, true);
  add("OBBRSS mesh", boxMesh<fcl::OBBRSS<S>>(half), {0, 0, 1}, upright, 1);
  add("KDOP16 mesh", boxMesh<fcl::KDOP<S, 16>>(half), {0, 0, 1}, upright, 1);
  add("KDOP18 mesh", boxMesh<fcl::KDOP<S, 18>>(half), {0, 0, 1}, upright, 1);
  add("KDOP24 mesh", boxMesh<fcl::KDOP<S, 24>>(half), {0, 0, 1}, upright, 1);
  add("octree", octree<S>(), {0, -1.25, -0.25}, upright, 1.5);
  add("octree's face", octree<S>(), {0, -1.25, 0}, upright, 1.5, true);
  return known;
}

template std::vector<Known<float>> knownGeometries();
template std::vector<Known<double>> knownGeometries();

}  // namespace tricover_fcl::test
