// SPDX-License-Identifier: BSD-3-Clause
#include <tricover/scene.h>

#include <iostream>

tricover::Pose at(double x, double y) { return tricover::Pose(Eigen::Translation2d(x, y)); }

int main() {
  const tricover::Polygon rack({{{0, 0}, {9, 0}, {9, 1}, {0, 1}}});
  const tricover::Polygon robot({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}});  // an L
  tricover::Scene scene;
  scene.add(rack, at(0, 4));
  const tricover::Scene::Body mover = scene.add(robot, at(0, 0));
  scene.add(robot, at(6, 0));

  for (double x = 2; x <= 4; ++x) {  // many against many: costs what has moved
    scene.move(mover, at(x, 0));
    std::cout << "x = " << x << ": " << scene.collisions().size() << " collisions, " << scene.began().size()
              << " new\n";
  }
  std::cout << "a third robot " << (scene.collides(robot, at(2, -3)) ? "collides" : "is free")  // one against many
            << ", " << scene.nearest(robot, at(2, -3))->result.distance << " from the nearest body\n";
  for (const tricover::PairImpact& hit : scene.impacts({{mover, tricover::Motion::translation(at(0, 0), {0, 4})}}))
    std::cout << hit.pair.first << " and " << hit.pair.second << " meet at time " << hit.impact.time << "\n";
  std::cout << "a ray up from (5.5, 3) meets body " << scene.castRay({5.5, 3}, {5.5, 9})->body << "\n";
}
