// SPDX-License-Identifier: BSD-3-Clause
#include <tricover/tricover.h>

#include <iostream>

int main() {
  using namespace tricover;
  const Polygon slot({{0, 0}, {6, 0}, {6, 3}, {4, 3}, {4, 1}, {2, 1}, {2, 3}, {0, 3}});  // a U
  const Polygon key = Polygon::box(1.5, 1.5);                                            // around the origin
  const Pose here = poseAt(0, 0), above = poseAt(3, 4.5), inside = poseAt(3, 1.5);

  std::cout << (collide(slot, here, key, above) ? "collides\n" : "is free\n");
  std::cout << "distance " << distance(slot, here, key, above).distance << "\n";
  std::cout << "depth " << penetration(slot, here, key, inside)->depth << "\n";
  const auto down = Motion::translation(above, {0, -3});
  const auto impact = timeOfImpact(slot, Motion::still(here), key, down);
  std::cout << "meets edge " << impact->edge_a << " at time " << impact->time << "\n";
  std::cout << (collide(slot, here, key, poseAt(3, 2.1), {0.3}) ? "is within 0.3\n" : "has 0.3 to spare\n");
}
