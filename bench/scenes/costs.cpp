// SPDX-License-Identifier: BSD-3-Clause
#include "costs.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <memory>

#include "askers.h"
#include "crowd.h"
#include "maps.h"
#include "measure.h"
#include "rivals/boost_tree.h"
#include "rivals/geos_tree.h"
#include "tricover/scene.h"

namespace tricover::bench {
namespace {

constexpr std::size_t kObstacles = 10000;
constexpr std::size_t kFew = 100;  // one body in so many

/// Bytes and seconds that `build` takes, what it makes being alive.
template <class Build>
std::pair<double, double> costOf(Build build) {
  const std::size_t before = heapBytes();
  const double start = threadSeconds();
  const auto built = build();
  const double seconds = threadSeconds() - start;
  return {static_cast<double>(heapBytes() - before), seconds};
}

/// Median seconds of a frame in which every body moves whose number `step` divides, the motion before left aside.
double secondsOfFrame(Scene& scene, std::size_t bodies, std::size_t step) {
  constexpr std::size_t kWarmUp = 6, kTimed = 9;
  std::vector<double> seconds;
  for (std::size_t frame = 1; frame <= kWarmUp + kTimed; ++frame) {
    const std::vector<Pose> poses = crowdPoses(kContourSpacing, bodies, frame);
    const double start = threadSeconds();
    for (std::size_t i = 0; i < bodies; i += step) scene.move(static_cast<Scene::Body>(i), poses[i]);
    scene.collisions();
    if (frame > kWarmUp) seconds.push_back(threadSeconds() - start);
  }
  return medianOf(seconds);
}

CrowdCost crowdCost(std::size_t bodies) {
  const Crowd crowd = makeCrowd(workloads::Kind::Contour, 64, kContourSpacing, bodies, 1);
  const auto filled = [&] {
    auto scene = std::make_unique<Scene>();
    for (std::size_t i = 0; i < bodies; ++i) scene->add(crowd.shapeOf(i), crowd.poses[0][i]);
    scene->collisions();
    return scene;
  };
  filled();  // the polygons' own hierarchies are there from now on
  const auto [bytes, seconds] = costOf(filled);
  const auto moving = filled();
  const auto count = static_cast<double>(bodies);
  const double all = secondsOfFrame(*moving, bodies, 1);
  // From where the bodies are: the frames begin anew, so that the first one is a leap, but for its warm-up.
  const double few = secondsOfFrame(*moving, bodies, kFew);
  return {bodies, 1e9 * all / count, 1e9 * few * kFew / count, bytes / count, 1e9 * seconds / count};
}

/// Two threads of oneTBB's.
Parallel onThreads(tbb::task_arena& arena) {
  return [&arena](std::size_t n, const std::function<void(std::size_t)>& task) {
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, n, task); });
  };
}

template <class Asker, class... Arguments>
MapCost mapCost(const std::string& name, const Placement& map, const Arguments&... arguments) {
  const Polygon robot = forkLift();
  const auto [bytes, seconds] = costOf([&] {
    auto asker = std::make_unique<Asker>(map, robot, arguments...);
    asker->prepare({map[map.size() / 2].pose});
    asker->collide(0);
    return asker;
  });
  const auto count = static_cast<double>(map.size());
  return {name, bytes / count, 1e9 * seconds / count};
}

}  // namespace

std::vector<CrowdCost> measureCrowdCosts() {
  std::vector<CrowdCost> costs;
  for (std::size_t bodies = 1000; bodies <= 100000U; bodies *= 10) costs.push_back(crowdCost(bodies));
  return costs;
}

FrameCost measureFrameOnThreads() {
  constexpr std::size_t kBodies = 100000;
  const Crowd crowd = makeCrowd(workloads::Kind::Contour, 64, kContourSpacing, kBodies, 1);
  Scene one, other;
  std::vector<BodyPose> moves;
  for (std::size_t i = 0; i < kBodies; ++i) {
    moves.push_back({one.add(crowd.shapeOf(i), crowd.poses[0][i]), crowd.poses[0][i]});
    other.add(crowd.shapeOf(i), crowd.poses[0][i]);
  }
  tbb::task_arena arena(2);
  const Parallel on_threads = onThreads(arena);
  std::size_t frame = 0;
  bool same = true;
  const auto next = [&] {
    const std::vector<Pose> poses = crowdPoses(kContourSpacing, kBodies, ++frame);
    for (std::size_t i = 0; i < kBodies; ++i) moves[i].pose = poses[i];
  };
  std::vector<double> serial, threads;
  const auto secondsOf = [&](Scene& scene, const Parallel& parallel) {
    const double start = wallSeconds();
    scene.move(moves, parallel);
    scene.collisions(parallel);
    return wallSeconds() - start;
  };
  constexpr std::size_t kWarmUp = 6, kTimed = 15;
  for (std::size_t i = 0; i < kWarmUp + kTimed; ++i) {
    next();
    const double alone = secondsOf(one, {}), together = secondsOf(other, on_threads);
    same = same && one.collisions() == other.collisions();
    if (i < kWarmUp) continue;
    serial.push_back(alone);
    threads.push_back(together);
  }
  const double ns = 1e9 / kBodies;
  return {kBodies, ns * medianOf(serial), ns * medianOf(threads), same};
}

std::vector<MapCost> measureMapCosts(const Countries& countries) {
  const Placement map = countriesMap(countries, kObstacles);
  // What belongs to polygons is there from now on, for ours and for FCL alike.
  const ScanAsker asked(map, forkLift());
  mapCost<SceneAsker>("", map);
  return {mapCost<SceneAsker>("scene", map), mapCost<FclAsker>("FCL, our shapes", map, fclManagers().front()),
          mapCost<GeosTree>("GEOS STRtree", map), mapCost<BoostTree>("Boost rtree", map)};
}

BatchCost measureBatch(const Countries& countries, bool full) {
  const std::size_t count = full ? 1000000 : 100000;
  const Placement map = countriesMap(countries, kObstacles);
  const Polygon robot = forkLift();
  const std::vector<Pose> poses = randomPoses(map, count, 6);
  Scene scene;
  for (const Placed& placed : map) scene.add(placed.polygon, placed.pose);
  std::vector<bool> one_by_one(count), serial, threads;
  tbb::task_arena arena(2);
  const Parallel on_threads = onThreads(arena);
  const std::vector<double> seconds =
      secondsInTurn({[&] {
                       for (std::size_t i = 0; i < count; ++i) one_by_one[i] = scene.collides(robot, poses[i]);
                     },
                     [&] { serial = scene.collides(robot, poses); },
                     [&] { threads = scene.collides(robot, poses, {}, kEveryCategory, on_threads); }},
                    5, wallSeconds);
  const bool same = one_by_one == serial && one_by_one == threads;
  const double ns = 1e9 / static_cast<double>(count);
  return {count, ns * seconds[0], ns * seconds[1], ns * seconds[2], same};
}

}  // namespace tricover::bench
