// SPDX-License-Identifier: BSD-3-Clause
// A plugin that a host opens by dlopen: two unit squares, queried by FCL's own functions and by tricover_fcl's.
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>
#include <tricover_fcl/tricover_fcl.h>

#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>

namespace {

fcl::Transform3d at(double x) {
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  pose.translation().x() = x;
  return pose;
}

/// Prints the answers: touching, and 0.5 apart.
template <typename Collide, typename Distance, typename ContinuousCollide, typename Callback>
void printAll(const Collide& collide, const Distance& distance, const ContinuousCollide& continuous_collide,
              Callback callback) {
  const auto square =
      std::make_shared<tricover_fcl::PolygonShaped>(tricover::Polygon({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}));
  for (const double x : {1.0, 1.5}) {
    for (const fcl::GJKSolverType solver : {fcl::GST_LIBCCD, fcl::GST_INDEP}) {
      fcl::CollisionRequestd request;
      request.gjk_solver_type = solver;
      fcl::CollisionResultd of_geometries, of_objects;
      collide(square.get(), at(0), square.get(), at(x), request, of_geometries);
      const fcl::CollisionObjectd object(square, at(0)), other(square, at(x));
      collide(&object, &other, request, of_objects);
      fcl::DistanceRequestd distance_request;
      distance_request.gjk_solver_type = solver;
      fcl::DistanceResultd result;
      fcl::ContinuousCollisionRequestd continuous_request;
      continuous_request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
      continuous_request.gjk_solver_type = solver;
      fcl::ContinuousCollisionResultd continuous;
      continuous_collide(square.get(), at(0), at(0.25), square.get(), at(x), at(x), continuous_request, continuous);
      std::cout << of_geometries.numContacts() << of_objects.numContacts() << " "
                << distance(square.get(), at(0), square.get(), at(x), distance_request, result) << " "
                << continuous.is_collide << ", ";
    }
  }
  fcl::CollisionObjectd object(square, at(0)), other(square, at(1));
  fcl::DynamicAABBTreeCollisionManagerd manager;
  manager.registerObject(&object);
  manager.registerObject(&other);
  manager.setup();
  fcl::DefaultCollisionData<double> data;
  manager.collide(&data, callback);
  std::cout << data.result.numContacts() << "\n";
}

}  // namespace

extern "C" __attribute__((visibility("default"))) void askPlugin() {
  const tricover_fcl::PolygonShaped made_first(tricover::Polygon({{{0, 0}, {1, 0}, {0, 1}}}));  // doesn't throw
  try {
    tricover_fcl::registerNarrowphase();
    std::cout << "registered\n";
    printAll([](auto&&... said) { return fcl::collide<double>(said...); },
             [](auto&&... said) { return fcl::distance<double>(said...); },
             [](auto&&... said) { return fcl::continuousCollide<double>(said...); },
             &fcl::DefaultCollisionFunction<double>);
  } catch (const std::logic_error& error) {
    const std::string text = error.what();
    for (const char* const remedy : {"before fcl", "LD_PRELOAD", "tricover_fcl::collide"})
      std::cout << (text.find(remedy) == std::string::npos ? "doesn't say " : "says ") << remedy << "\n";
  }
  printAll([](auto&&... said) { return tricover_fcl::collide<double>(said...); },
           [](auto&&... said) { return tricover_fcl::distance<double>(said...); },
           [](auto&&... said) { return tricover_fcl::continuousCollide<double>(said...); },
           &tricover_fcl::defaultCollisionFunction<double>);
}
