// SPDX-License-Identifier: BSD-3-Clause
// What a host opens by dlopen: two unit squares, asked of by FCL's own functions.
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>
#include <tricover_fcl/tricover_fcl.h>

#include <iostream>
#include <memory>

namespace {

fcl::Transform3d at(double x) {
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  pose.translation().x() = x;
  return pose;
}

}  // namespace

/// Prints the answers: touching, and 0.5 apart. `is_checked`: registers before.
extern "C" __attribute__((visibility("default"))) void askPlugin(bool is_checked) {
  const auto square =
      std::make_shared<tricover_fcl::PolygonShaped>(tricover::Polygon({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}));
  if (is_checked) tricover_fcl::registerNarrowphase();
  for (const double x : {1.0, 1.5}) {
    for (const fcl::GJKSolverType solver : {fcl::GST_LIBCCD, fcl::GST_INDEP}) {
      fcl::CollisionRequestd request;
      request.gjk_solver_type = solver;
      fcl::CollisionResultd of_geometries, of_objects;
      fcl::collide<double>(square.get(), at(0), square.get(), at(x), request, of_geometries);
      const fcl::CollisionObjectd object(square, at(0)), other(square, at(x));
      fcl::collide<double>(&object, &other, request, of_objects);
      fcl::DistanceRequestd distance_request;
      distance_request.gjk_solver_type = solver;
      fcl::DistanceResultd distance;
      fcl::ContinuousCollisionRequestd continuous_request;
      continuous_request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
      continuous_request.gjk_solver_type = solver;
      fcl::ContinuousCollisionResultd continuous;
      fcl::continuousCollide<double>(square.get(), at(0), at(0.25), square.get(), at(x), at(x), continuous_request,
                                     continuous);
      std::cout << of_geometries.numContacts() << of_objects.numContacts() << " "
                << fcl::distance<double>(square.get(), at(0), square.get(), at(x), distance_request, distance) << " "
                << continuous.is_collide << ", ";
    }
  }
  fcl::CollisionObjectd object(square, at(0)), other(square, at(1));
  fcl::DynamicAABBTreeCollisionManagerd manager;
  manager.registerObject(&object);
  manager.registerObject(&other);
  manager.setup();
  fcl::DefaultCollisionData<double> data;
  manager.collide(&data, fcl::DefaultCollisionFunction<double>);
  std::cout << data.result.numContacts() << "\n";
}
