// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "asked.h"
#include "layout.h"
#include "shapes.h"

namespace tricover::bench {
namespace {

/// A part that was taken out, and where it is tried.
struct Trial {
  Polygon part;
  std::vector<Pose> poses;
  CoreScan scan;
  Scene scene;
};

Result costOf(const Placement& layout, const std::string& parts, Placing placing, const std::string& name) {
  // A frame around the layout, with a hole that it fills.
  const Eigen::AlignedBox2d hole = boundsOf(layout);
  const Vec2 low = hole.min() - hole.sizes(), high = hole.max() + hole.sizes();
  const Placed container = {
      Polygon({support::rectangle(low.x(), low.y(), high.x(), high.y()),
               support::rectangle(hole.min().x(), hole.min().y(), hole.max().x(), hole.max().y())}),
      Pose::Identity()};
  std::vector<Trial> trials;
  for (const Lifted& lifted : liftedParts(layout)) {
    Placement bodies = lifted.others;
    bodies.push_back(container);
    trials.push_back({lifted.part.polygon, placings(lifted, placing, kPlacings, lifted.index), CoreScan(lifted.others),
                      sceneOf(bodies)});
  }
  const std::size_t count = trials.size() * kPlacings;
  std::vector<double> by_scan(count), by_scene(count);
  const auto scan = [&](std::size_t i) {
    const Trial& trial = trials[i / kPlacings];
    const Pose& pose = trial.poses[i % kPlacings];
    return trial.scan.collides(trial.part, pose) ||
           (!hole.contains(boundsOf(trial.part, pose)) && collide(container.polygon, container.pose, trial.part, pose));
  };
  const auto scene = [&](std::size_t i) {
    const Trial& trial = trials[i / kPlacings];
    return trial.scene.collides(trial.part, trial.poses[i % kPlacings]);
  };
  Result result =
      measureInTurn({"container", parts, name, 0, 0, count},
                    {taskOf("scan", Role::Rival, by_scan, scan), taskOf("scene", Role::Ours, by_scene, scene)}, 9);
  if (by_scan != by_scene) throw std::logic_error("containers: scan and scene differ: " + parts + ", " + name);
  result.collisions = static_cast<std::size_t>(std::count(by_scan.begin(), by_scan.end(), 1));
  return result;
}

}  // namespace

std::vector<Result> measureContainers() {
  std::vector<Result> results;
  for (const auto& [parts, least, most] : {std::tuple(16, 5, 8),
                                           {20, 5, 8},
                                           {20, 12, 25},
                                           {50, 5, 8},
                                           {50, 12, 25},
                                           {80, 5, 8},
                                           {80, 12, 20},
                                           {80, 40, 64}}) {
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
