// SPDX-License-Identifier: BSD-3-Clause
#include "containers.h"

#include <utility>

#include "core_scan.h"
#include "layout.h"
#include "measure.h"
#include "tricover/scene.h"

namespace tricover::bench {
namespace {

/// A frame around the layout, with a hole that it fills.
Placed containerOf(const Eigen::AlignedBox2d& hole) {
  const auto ring = [](const Vec2& low, const Vec2& high) {
    return Ring{low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  };
  const Vec2 wide = hole.sizes();
  return {Polygon({ring(hole.min() - wide, hole.max() + wide), ring(hole.min(), hole.max())}), poseAt({0, 0}, 0)};
}

/// A part that was taken out, and where it is tried.
struct Trial {
  Polygon part;
  std::vector<Pose> poses;
  CoreScan scan;
  Scene scene;
  SceneCache cache;
};

std::vector<Trial> trialsIn(const Placement& layout, const Placed& container, Placing placing) {
  constexpr std::size_t kLifted = 8, kPoses = 125;
  std::vector<Trial> trials;
  for (std::size_t k = 0; k < kLifted; ++k) {
    const std::size_t part = k * layout.size() / kLifted;
    Placement others = layout;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(part));
    Trial trial{layout[part].polygon, placings(layout[part], others, placing, kPoses, part), CoreScan(others), {}, {}};
    for (const Placed& other : others) trial.scene.add(other.polygon, other.pose);
    trial.scene.add(container.polygon, container.pose);
    trials.push_back(std::move(trial));
  }
  return trials;
}

ContainerCost costOf(const Placement& layout, const std::string& parts, Placing placing, const std::string& name) {
  const Eigen::AlignedBox2d hole = boundsOf(layout);
  const Placed container = containerOf(hole);
  std::vector<Trial> trials = trialsIn(layout, container, placing);
  std::vector<bool> by_scan, by_scene, by_cache;
  const auto task = [&](std::vector<bool>& answers, auto ask) {
    return [&trials, &answers, ask] {
      answers.clear();
      for (Trial& trial : trials)
        for (const Pose& pose : trial.poses) answers.push_back(ask(trial, pose));
    };
  };
  const auto scan = [&](const Trial& trial, const Pose& pose) {
    return trial.scan.collides(trial.part, pose) ||
           (!hole.contains(boundsOf(trial.part, pose)) && collide(container.polygon, container.pose, trial.part, pose));
  };
  const auto scene = [](const Trial& trial, const Pose& pose) { return trial.scene.collides(trial.part, pose); };
  const auto cached = [](Trial& trial, const Pose& pose) {
    return trial.scene.collides(trial.part, pose, trial.cache);
  };
  const std::vector<double> seconds =
      secondsInTurn({task(by_scan, scan), task(by_scene, scene), task(by_cache, cached)}, 9, threadSeconds);
  double hits = 0;
  for (const bool hit : by_scan) hits += hit ? 1 : 0;
  const auto count = static_cast<double>(by_scan.size());
  return {parts,
          name,
          hits / count,
          1e9 * seconds[0] / count,
          1e9 * seconds[1] / count,
          1e9 * seconds[2] / count,
          by_scan == by_scene && by_scan == by_cache};
}

}  // namespace

std::vector<ContainerCost> measureContainers() {
  std::vector<ContainerCost> costs;
  for (const auto& [parts, least, most] : {std::tuple(16, 5, 8), {80, 5, 8}, {80, 12, 20}, {80, 40, 64}}) {
    const Placement layout = makeLayout(static_cast<std::size_t>(parts), least, most, 7);
    const std::string name = std::to_string(parts) + " of " + std::to_string(least) + " to " + std::to_string(most);
    for (const auto& [placing, way] : {std::pair(Placing::Free, "free"),
                                       {Placing::Local, "local"},
                                       {Placing::LocalWide, "local, wide"},
                                       {Placing::Uniform, "uniform"}})
      costs.push_back(costOf(layout, name, placing, way));
  }
  return costs;
}

std::vector<Target> judgeContainers(const std::vector<ContainerCost>& costs) {
  std::vector<Figure> few, many, cached;
  for (const ContainerCost& cost : costs) {
    const std::string cell = cost.parts + ", " + cost.placing;
    (cost.parts.rfind("80", 0) == 0 ? many : few).push_back({cost.scan_ns / cost.scene_ns, cell});
    cached.push_back({cost.cached_ns / cost.scene_ns, cell});
  }
  const std::string subject = "a part in its container, among ", compared = "a scan of boxes and our pairs / scene";
  return {judged(subject + "16", compared, few, {true, 1.2}), judged(subject + "80", compared, many, {true, 1.5}),
          judged("a part in its container", "with a SceneCache / without", cached, {false, 1.05})};
}

}  // namespace tricover::bench
