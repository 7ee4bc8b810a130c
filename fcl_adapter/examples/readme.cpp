// SPDX-License-Identifier: BSD-3-Clause
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <tricover_fcl/tricover_fcl.h>

#include <iostream>

int main() {
  tricover_fcl::registerNarrowphase();  // once: checks that FCL's functions reach tricover

  const tricover::Polygon room({{{0, 0}, {9, 0}, {9, 7}, {0, 7}}, {{1, 1}, {8, 1}, {8, 6}, {1, 6}}});  // ring in ring
  const tricover::Polygon robot({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}});                   // an L
  const auto planar = tricover_fcl::PolygonOptions::atAllHeights();  // z doesn't matter
  fcl::CollisionObjectd walls(std::make_shared<tricover_fcl::PolygonShaped>(room, planar));
  fcl::CollisionObjectd driven(std::make_shared<tricover_fcl::PolygonShaped>(robot, planar));

  fcl::DynamicAABBTreeCollisionManagerd manager;
  manager.registerObject(&walls);
  manager.setup();
  for (double x = 3; x <= 7; ++x) {
    driven.setTranslation(fcl::Vector3d(x, 3, 0));
    driven.computeAABB();
    fcl::DefaultCollisionData<double> data;
    manager.collide(&driven, &data, fcl::DefaultCollisionFunction);
    std::cout << "x = " << x << (data.result.isCollision() ? ": collides\n" : ": free\n");
  }
}
