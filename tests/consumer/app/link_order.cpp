// SPDX-License-Identifier: BSD-3-Clause
// Says whether FCL's functions reach tricover in this program, and what they answer for a touch and for a gap.
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>
#include <tricover_fcl/tricover_fcl.h>

#include <iostream>
#include <stdexcept>

namespace {

/// The answers for unit squares side by side: touching, and 0.5 apart.
template <typename Query>
void print(const char* name, const Query& query) {
  const tricover_fcl::PolygonShaped square(tricover::Polygon({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}));
  std::cout << name << ":";
  for (const double x : {1.0, 1.5}) {
    fcl::Transform3d beside = fcl::Transform3d::Identity();
    beside.translation().x() = x;
    std::cout << " " << query(&square, fcl::Transform3d::Identity(), beside);
  }
  std::cout << "\n";
}

using Shape = const tricover_fcl::PolygonShaped*;
using Pose = const fcl::Transform3d&;

/// FCL's functions, or tricover_fcl's of the same names.
template <typename Collide, typename Distance, typename ContinuousCollide>
void printAll(const Collide& collide, const Distance& distance, const ContinuousCollide& continuous_collide) {
  print("collide", [&](Shape shape, Pose here, Pose beside) {
    fcl::CollisionResultd result;
    return collide(shape, here, shape, beside, fcl::CollisionRequestd(), result);
  });
  print("distance", [&](Shape shape, Pose here, Pose beside) {
    fcl::DistanceResultd result;
    return distance(shape, here, shape, beside, fcl::DistanceRequestd(), result);
  });
  print("continuousCollide", [&](Shape shape, Pose here, Pose beside) {
    fcl::ContinuousCollisionRequestd request;
    request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
    fcl::ContinuousCollisionResultd result;
    fcl::Transform3d end = here;
    end.translation().x() = 0.25;
    continuous_collide(shape, here, end, shape, beside, beside, request, result);
    return result.is_collide;
  });
}

}  // namespace

int main() {
  try {
    tricover_fcl::registerNarrowphase();
    std::cout << "registered\n";
    printAll([](auto&&... arguments) { return fcl::collide<double>(arguments...); },
             [](auto&&... arguments) { return fcl::distance<double>(arguments...); },
             [](auto&&... arguments) { return fcl::continuousCollide<double>(arguments...); });
  } catch (const std::logic_error& error) {
    std::cout << "refused: " << error.what() << "\n";
  }
  std::cout << "tricover_fcl\n";
  printAll([](auto&&... arguments) { return tricover_fcl::collide<double>(arguments...); },
           [](auto&&... arguments) { return tricover_fcl::distance<double>(arguments...); },
           [](auto&&... arguments) { return tricover_fcl::continuousCollide<double>(arguments...); });
}
