// SPDX-License-Identifier: BSD-3-Clause
// Writes a recording to its argument: robots among racks, by trajectories of every kind and by frames, and one whose
// name is no HTML. Prints what the library says at some times, a line a body: time, body, x, y and heading (NaN where
// it isn't there), margin, and whether it meets another one (-1 where nothing says so).
#include <tricover/tricover.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
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

/// The page numbers bodies by their handles: the one that comes back is the last.
void print(double time, std::size_t body, const Pose& at, double margin, int meets) {
  std::printf("%.17g %zu %.17g %.17g %.17g %.17g %d\n", time, body, at.translation().x(), at.translation().y(),
              std::atan2(at.linear()(1, 0), at.linear()(0, 0)), margin, meets);
}

constexpr double kTimes[] = {0, 4.5, 7.3, 14.9, 15, 20, 29.7};

/// Bodies by a frame for each time: what moves, rests and moves again, turns over, grows its margin, appears, goes and
/// comes back. The first two meet in frames 1, 2, 4 and 5.
void addFrames(Scene& scene, SceneRecording& recording) {
  const Polygon part({{0, 0}, {1, 0}, {1, 0.3}, {0.3, 0.3}, {0.3, 1}, {0, 1}});
  std::vector<Scene::Body> bodies;
  for (int i = 0; i < 5; ++i) bodies.push_back(scene.add(part, poseAt(-3 * i, -5), {0.05}));
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::size_t frame = 0;
  std::size_t numbers[5];
  for (std::size_t i = 0; i < 5; ++i) numbers[i] = Scene::indexOf(bodies[i]);
  for (const double time : kTimes) {
    const double f = static_cast<double>(frame);
    scene.move(bodies[0], poseAt(f, -4, 0.3 * f));
    if (frame >= 3) scene.move(bodies[1], poseAt(-3 - f, -5, f));
    Pose turned_over = poseAt(-6 + f, -7, 0.1 * f);
    if (frame >= 2) turned_over.linear().col(1) *= -1;
    scene.move(bodies[2], turned_over);
    if (frame == 4) scene.setOptions(bodies[3], {0.4});
    if (frame == 2) scene.remove(bodies[4]);
    if (frame == 5) {
      bodies[4] = scene.add(part, poseAt(-12, -9, 1), {0.05});
      ++numbers[4];
    }
    const bool meet = frame == 1 || frame == 2 || frame == 4 || frame == 5;
    recording.frame(time, scene, meet ? std::vector<BodyPair>{{bodies[0], bodies[1]}} : std::vector<BodyPair>{});
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const bool is_there = scene.contains(bodies[i]);
      print(time, numbers[i], is_there ? scene.pose(bodies[i]) : poseAt(kNone, kNone),
            is_there ? scene.options(bodies[i]).margin : 0, i < 2 && meet);
    }
    if (time == 14.9) recording.text({2, 3}, "until the next frame");
    ++frame;
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
  recording.text({2, 3}, "from 4 to 6", TimeInterval{4, 6});
  recording.name(plans[3].body, "</script><b>");
  addFrames(scene, recording);
  recording.save(argv[1]);
  for (const double time : kTimes)
    for (const auto& [body, way] : plans)
      if (way.isThere(time)) print(time, Scene::indexOf(body), way.at(time), 0.1, -1);
}
