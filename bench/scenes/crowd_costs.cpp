// SPDX-License-Identifier: BSD-3-Clause
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <stdexcept>
#include <string>

#include "crowd.h"
#include "scene_studies.h"
#include "tricover/scene.h"

namespace tricover::bench {
namespace {

Scene sceneOf(const Crowd& crowd) {
  Scene scene;
  for (std::size_t i = 0; i < crowd.size(); ++i) scene.add(crowd.shapeOf(i), crowd.poses[0][i]);
  return scene;
}

/// Frames in which every `step`th body moves: on one thread by CPU time, then on one and on two by wall time.
/// Nanoseconds a moving body.
Result measured(std::size_t bodies, std::size_t step) {
  constexpr std::size_t kWarmUp = 6, kTimed = 9;
  const Crowd crowd = makeCrowd(workloads::Kind::Contour, 64, kContourSpacing, bodies, 1);
  Scene one = sceneOf(crowd), other = sceneOf(crowd);
  tbb::task_arena arena(2);
  const Parallel on_threads = [&arena](std::size_t n, const std::function<void(std::size_t)>& task) {
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, n, task); });
  };
  std::vector<double> cpu, serial, threads;
  for (std::size_t frame = 1; frame <= kWarmUp + kTimed; ++frame) {
    const std::vector<Pose> poses = crowdPoses(kContourSpacing, bodies, frame);
    std::vector<BodyPose> moves;
    for (std::size_t i = 0; i < bodies; i += step) moves.push_back({static_cast<Scene::Body>(i), poses[i]});
    const double cpu_start = threadSeconds(), start = wallSeconds();
    one.move(moves);
    one.collisions();
    const double cpu_end = threadSeconds(), middle = wallSeconds();
    other.move(moves, on_threads);
    other.collisions(on_threads);
    const double end = wallSeconds();
    if (one.collisions() != other.collisions()) throw std::logic_error("crowds: threads change the answer");
    if (frame <= kWarmUp) continue;
    cpu.push_back(cpu_end - cpu_start);
    serial.push_back(middle - start);
    threads.push_back(end - middle);
  }
  const double ns = 1e9 * static_cast<double>(step) / static_cast<double>(bodies);
  const std::string name = step == 1 ? "all moving" : "one in " + std::to_string(step) + " moving";
  return {{"crowd", std::to_string(bodies) + " bodies", name, 64, 64, 1, 1},
          0,
          {{"scene", Role::Ours, ns * medianOf(cpu), 0, 0, 0},
           {"wall time", Role::Floor, ns * medianOf(serial), 0, 0, 0},
           {"wall time, two threads", Role::Floor, ns * medianOf(threads), 0, 0, 0}}};
}

}  // namespace

std::vector<Result> measureCrowds() {
  std::vector<Result> results;
  for (std::size_t bodies = 1000; bodies <= 100000U; bodies *= 10)
    for (const std::size_t step : {1u, 100u}) results.push_back(measured(bodies, step));
  return results;
}

}  // namespace tricover::bench
