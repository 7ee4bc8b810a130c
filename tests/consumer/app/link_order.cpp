// SPDX-License-Identifier: BSD-3-Clause
// Says whether fcl::collide reaches tricover in this program, and what the calls answer for a touch and for a gap.
#include <fcl/narrowphase/collision.h>
#include <tricover_fcl/tricover_fcl.h>

#include <iostream>
#include <stdexcept>

namespace {

template <typename Collide>
void print(const char* name, const Collide& collide) {
  const tricover_fcl::PolygonShaped square(tricover::Polygon({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}));
  std::cout << name << ":";
  for (const double x : {1.0, 1.5}) {
    fcl::Transform3d beside = fcl::Transform3d::Identity();
    beside.translation().x() = x;
    fcl::CollisionResultd result;
    std::cout << " " << collide(&square, fcl::Transform3d::Identity(), &square, beside, result);
  }
  std::cout << "\n";
}

}  // namespace

int main() {
  const auto through_fcl = [](const auto* a, const auto& tf_a, const auto* b, const auto& tf_b, auto& result) {
    return fcl::collide<double>(a, tf_a, b, tf_b, fcl::CollisionRequestd(), result);
  };
  const auto directly = [](const auto* a, const auto& tf_a, const auto* b, const auto& tf_b, auto& result) {
    return tricover_fcl::collide<double>(a, tf_a, b, tf_b, fcl::CollisionRequestd(), result);
  };
  try {
    tricover_fcl::registerNarrowphase();
    std::cout << "registered\n";
    print("fcl::collide", through_fcl);
  } catch (const std::logic_error& error) {
    std::cout << "refused: " << error.what() << "\n";
  }
  print("tricover_fcl::collide", directly);
}
