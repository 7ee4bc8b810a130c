// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>
#include <string>
#include <utility>

#include "asked.h"
#include "core_scan.h"
#include "layout.h"
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
};

std::vector<Trial> trialsIn(const Placement& layout, const Placed& container, Placing placing) {
  constexpr std::size_t kLifted = 8, kPoses = 125;
  std::vector<Trial> trials;
  for (std::size_t k = 0; k < kLifted; ++k) {
    const std::size_t part = k * layout.size() / kLifted;
    Placement others = layout;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(part));
    Trial trial{layout[part].polygon, placings(layout[part], others, placing, kPoses, part), CoreScan(others), {}};
    for (const Placed& other : others) trial.scene.add(other.polygon, other.pose);
    trial.scene.add(container.polygon, container.pose);
    trials.push_back(std::move(trial));
  }
  return trials;
}

Result costOf(const Placement& layout, const std::string& parts, Placing placing, const std::string& name) {
  const Eigen::AlignedBox2d hole = boundsOf(layout);
  const Placed container = containerOf(hole);
  std::vector<Trial> trials = trialsIn(layout, container, placing);
  std::vector<bool> by_scan, by_scene;
  const auto task = [&](const char* method, Role role, std::vector<bool>& answers, auto ask) {
    return Task{method, role, [&trials, &answers, ask] {
                  answers.clear();
                  for (const Trial& trial : trials)
                    for (const Pose& pose : trial.poses) answers.push_back(ask(trial, pose));
                }};
  };
  const auto scan = [&](const Trial& trial, const Pose& pose) {
    return trial.scan.collides(trial.part, pose) ||
           (!hole.contains(boundsOf(trial.part, pose)) && collide(container.polygon, container.pose, trial.part, pose));
  };
  const auto scene = [](const Trial& trial, const Pose& pose) { return trial.scene.collides(trial.part, pose); };
  const std::size_t queries = trials.size() * trials.front().poses.size();
  Result result =
      measureInTurn({"container", parts, name, 0, 0, queries, 1},
                    {task("scan", Role::Rival, by_scan, scan), task("scene", Role::Ours, by_scene, scene)}, 9);
  if (by_scan != by_scene) throw std::logic_error("containers: scan and scene differ: " + parts + ", " + name);
  for (const bool hit : by_scan) result.collisions += hit ? 1 : 0;
  return result;
}

}  // namespace

std::vector<Result> measureContainers() {
  std::vector<Result> results;
  for (const auto& [parts, least, most] : {std::tuple(16, 5, 8), {80, 5, 8}, {80, 12, 20}, {80, 40, 64}}) {
    const Placement layout = makeLayout(static_cast<std::size_t>(parts), least, most, 7);
    const std::string name =
        std::to_string(parts) + " parts of " + std::to_string(least) + " to " + std::to_string(most) + " vertices";
    for (const auto& [placing, way] : {std::pair(Placing::Free, "free"),
                                       {Placing::Local, "local"},
                                       {Placing::LocalWide, "local and wide"},
                                       {Placing::Uniform, "uniform"}})
      results.push_back(costOf(layout, name, placing, way));
  }
  return results;
}

}  // namespace tricover::bench
