// SPDX-License-Identifier: BSD-3-Clause
// A robot docks at a platform, slides along it and leaves. Poses are written in decimals, so the docked robot is a
// rounding away from the platform or within it.
#include <tricover/tricover.h>

#include <iostream>

using tricover::poseAt;

int main(int argc, char** argv) {
  // The platform's top is at y = 0.5, and a stop is on it at x = 4.
  const tricover::Polygon platform({{{0, -0.5}, {6, -0.5}, {6, 1.5}, {4, 1.5}, {4, 0.5}, {0, 0.5}}});
  const tricover::Polygon robot = tricover::Polygon::box(1, 0.6);
  const auto still = tricover::Motion::still(poseAt(0, 0));

  // Leaves: contact at the start doesn't count, nor does the separation itself.
  tricover::ImpactOptions leaving;
  leaving.ignore_initial = true;
  const auto up = tricover::Motion::translation(poseAt(1, 0.8), {0, 1});
  std::cout << (timeOfImpact(platform, still, robot, up, leaving) ? "is stuck\n" : "leaves freely\n");

  // Slides: an overlap of a micrometre is allowed, and the stop isn't overlooked.
  tricover::ImpactOptions sliding;
  sliding.margin = -1e-6;
  const auto along = [](double length) { return tricover::Motion::translation(poseAt(1, 0.8), {length, 0}); };
  std::cout << (timeOfImpact(platform, still, robot, along(2), sliding) ? "is stuck\n" : "slides freely\n");
  if (const auto impact = timeOfImpact(platform, still, robot, along(4), sliding))
    std::cout << "hits the stop at time " << impact->time << ", edge " << impact->edge_a << "\n";

  // All of it by the clock: comes down, slides from 2 s to 4 s, leaves.
  const auto rest = tricover::Trajectory::through({{0, poseAt(0, 0)}, {6, poseAt(0, 0)}});
  const auto way =
      tricover::Trajectory::through({{0, poseAt(1, 2)}, {2, poseAt(1, 0.8)}, {4, poseAt(3, 0.8)}, {6, poseAt(3, 2)}});
  for (const tricover::Conflict& contact : conflicts(platform, rest, robot, way))
    std::cout << "in contact from " << contact.impact.time << " s to " << contact.end << " s\n";
  std::cout << conflicts(platform, rest, robot, way, sliding).size() << " collisions\n";

  tricover::Scene scene;
  scene.add(platform, poseAt(0, 0));
  const std::vector<tricover::BodyTrajectory> moving{{scene.add(robot, way.at(0)), way}};
  tricover::SceneRecording recording("Docking");
  recording.trajectories(scene, moving);
  recording.conflicts(scene.conflicts(moving));
  recording.save(argc > 1 ? argv[1] : "docking.html");  // for a browser
}
