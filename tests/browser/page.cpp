// SPDX-License-Identifier: BSD-3-Clause
// Writes a recording to its argument: robots among racks, by trajectories of every kind, and one whose name is no HTML.
// Prints where Trajectory::at() puts them at some times: "time body x y heading".
#include <tricover/tricover.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vector>

using namespace tricover;

namespace {

Trajectory anyTrajectory(std::size_t i) {
  const double a = static_cast<double>(i), x = 3 * std::fmod(a, 7), y = 2 * std::fmod(a, 5), begin = std::fmod(a, 4);
  switch (i % 5) {
    case 0:
      return Trajectory::through(
          {{begin, poseAt(x, y, a)}, {begin + 9, poseAt(20 - x, y + 3, 2 * a)}, {30, poseAt(x, 12, a)}});
    case 1:
      return Trajectory::spline(
          {{begin, {{x, y}, a, {2, 1}, 0.3}}, {12, {{9, 9}, 2, {-1, 2}, -1}}, {30, {{y, x}, 9, {0, 1}, 0}}},
          {0.3, -0.1});
    case 2:
      return Trajectory(
          {{begin, 15, Motion::arc(poseAt(x, y, a), {10, 6}, 4)}, {15, 30, Motion::still(poseAt(y, x))}});  // a jump
    case 3: {
      Pose mirrored = poseAt(x, y, a);
      mirrored.linear().col(1) *= -1;
      return Trajectory({{begin, 30, Motion::translation(mirrored, {8, 5})}}).appearing().vanishing();
    }
    default:
      return Trajectory::through(std::vector<Waypoint>{{begin, {x, y}, 0}, {20, {y, x}, 40}, {30, {x, x}, 40}},
                                 {0.2, 0.2});
  }
}

}  // namespace

int main(int, char** argv) {
  Scene scene;
  std::vector<Ring> racks;
  for (double x = 0; x < 20; x += 6) racks.push_back({{x, 5}, {x + 3, 5}, {x + 3, 6}, {x, 6}});
  scene.add(Polygon(racks), poseAt(0, 0));
  std::vector<BodyTrajectory> plans;
  BodyOptions options;
  options.margin = 0.1;
  for (std::size_t i = 0; i < 50; ++i) {
    options.category = 1U << (i % 2);
    const Trajectory way = anyTrajectory(i);
    plans.push_back({scene.add(Polygon::box(0.8, 0.6), way.at(0), options), way});
  }
  SceneRecording recording("Fifty robots <among> racks");
  recording.trajectories(scene, plans);
  recording.conflicts(scene.conflicts(plans, {0, 1e-3, true}));
  recording.name(plans[3].body, "</script><b>");
  recording.save(argv[1]);
  for (const double time : {0.0, 4.5, 7.3, 14.9, 15.0, 20.0, 29.7})
    for (const auto& [body, way] : plans) {
      const Pose at = way.at(time);
      if (way.isThere(time))
        std::printf("%.17g %llu %.17g %.17g %.17g\n", time, static_cast<unsigned long long>(body), at.translation().x(),
                    at.translation().y(), std::atan2(at.linear()(1, 0), at.linear()(0, 0)));
    }
}
