// SPDX-License-Identifier: BSD-3-Clause
// A fleet in a warehouse: robots drive among racks by a clock, dock, and leave; one appears from a lift and vanishes
// into another. Who is in conflict with whom, from when to when? Writes a recording, which a browser plays. usage:
// warehouse warehouse.html
#include <tricover/tricover.h>

#include <cmath>
#include <iostream>

using namespace tricover;

int main(int argc, char** argv) {
  Scene scene;
  std::vector<Ring> racks;
  for (const double x : {0, 6, 12})
    for (const double y : {0.0, 3.5}) racks.push_back({{x, y}, {x + 5, y}, {x + 5, y + 1.5}, {x, y + 1.5}});
  scene.add(Polygon(racks), poseAt(0, 0));
  const auto dock = scene.add(Polygon({{0, 0}, {1, 0}, {1, 0.2}, {0.2, 0.2}, {0.2, 1}, {0, 1}}), poseAt(-3, 1.5));

  const Polygon robot = Polygon::box(0.8, 0.6);
  BodyOptions options;
  options.margin = 0.1;  // metres that a robot keeps around it
  const auto add = [&](const Trajectory& way) { return BodyTrajectory{scene.add(robot, way.at(0), options), way}; };
  const std::vector<BodyTrajectory> plans = {
      add(Trajectory::through(
          {{0, poseAt(17, 2.5)}, {18, poseAt(-1, 2.5)}, {20, poseAt(-2.4, 2)}, {30, poseAt(-2.4, 2)}})),
      add(Trajectory::through({{0, poseAt(5.5, -1, M_PI / 2)},
                               {4, poseAt(5.5, 2.5, M_PI / 2)},
                               {6, poseAt(5.5, 2.5)},
                               {30, poseAt(17, 2.5)}})),
      add(Trajectory::through({{10, poseAt(0, 2.5)}, {22, poseAt(12, 2.5)}}).appearing().vanishing())};  // the lifts
  scene.setIgnored(dock, plans[0].body);  // it docks there

  const std::vector<PairConflict> conflicts = scene.conflicts(plans);
  for (const auto& [pair, conflict] : conflicts)
    std::cout << "bodies " << pair.first << " and " << pair.second << ": " << conflict.impact.time << " s to "
              << conflict.end << " s\n";

  SceneRecording recording("A warehouse");
  recording.trajectories(scene, plans);
  recording.conflicts(conflicts);
  recording.name(dock, "dock");
  recording.save(argc > 1 ? argv[1] : "warehouse.html");
}
