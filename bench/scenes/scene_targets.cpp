// SPDX-License-Identifier: BSD-3-Clause
#include "scene_targets.h"

#include <algorithm>
#include <string>

#include "report.h"

namespace tricover::bench {
namespace {

/// The fastest of the methods whose names begin like that.
std::optional<double> fastestNamed(const Result& result, const std::string& start) {
  std::optional<double> ns;
  for (const Timing& timing : result.timings) {
    if (timing.name.rfind(start, 0) == 0 && (!ns || timing.ns < *ns)) ns = timing.ns;
  }
  return ns;
}

const char* const kFclText = "our shapes in FCL's best manager / scene";

void judgeFrames(const std::vector<FramesResult>& frames, std::vector<Target>& targets) {
  for (const FramesResult& of_kind : frames) {
    const Result& result = of_kind.result;
    const double scene = *nsOf(result, "scene"), shapes = *fastestNamed(result, "via FCL");
    const double bvh = *nsOf(result, "FCL BVH"), alone = *nsOf(result, "manager alone");
    const double tree = *nsOf(result, "via FCL");
    const std::string subject = "2000 moving, " + result.workload.scene + ", whole frames";
    const std::string share = shortNumber(100 * of_kind.colliding) + " % colliding";
    const auto add = [&](const std::string& compared, double ratio, double wanted) {
      targets.push_back(judged(subject, compared, {{ratio, share}}, {true, wanted}));
    };
    if (const auto box2d = fastest(result, Role::Box2d)) {
      add("Box2D, its best scale / scene", *box2d / scene, 2);
      continue;
    }
    add("BVH meshes / scene", bvh / scene, 10);
    add(kFclText, shapes / scene, 4);
    add("BVH meshes / via FCL", bvh / tree, 10);
    add("BVH meshes / via FCL, less the manager alone", (bvh - alone) / (tree - alone), 10);
  }
}

void judgeGrowth(const std::vector<CrowdCost>& crowds, std::vector<Target>& targets) {
  const CrowdCost &first = crowds.front(), &last = crowds.back();
  const std::string sizes = std::to_string(first.bodies) + " to " + std::to_string(last.bodies) + " bodies";
  targets.push_back(judged("a moving body, " + sizes, "scene / scene",
                           {{last.all_moving_ns / first.all_moving_ns, "all moving"},
                            {last.few_moving_ns / first.few_moving_ns, "1 % moving"}},
                           {false, 1.5}));
}

/// The cells of one kind; ours as the workload has it used: with a SceneCache where there is coherence.
void judgeQueries(const std::string& subject, const std::vector<Result>& results, double over_scan, double over_rivals,
                  std::vector<Target>& targets) {
  std::vector<Figure> scan, fcl, geos, boost;
  for (const Result& result : results) {
    const double scene = nsOf(result, "scene, cached").value_or(*nsOf(result, "scene"));
    const auto add = [&](std::vector<Figure>& figures, double ns) {
      figures.push_back({ns / scene, cellName(result)});
    };
    add(scan, *nsOf(result, "cold"));
    add(fcl, *fastestNamed(result, "via FCL"));
    add(geos, *nsOf(result, "GEOS STRtree"));
    add(boost, *nsOf(result, "Boost rtree"));
  }
  targets.push_back(judged(subject, "core behind a scan of boxes / scene", scan, {true, over_scan}));
  targets.push_back(judged(subject, kFclText, fcl, {true, over_rivals}));
  targets.push_back(judged(subject, "GEOS STRtree, prepared / scene", geos, {true, over_rivals}));
  targets.push_back(judged(subject, "Boost rtree / scene", boost, {true, over_rivals}));
}

}  // namespace

std::vector<Target> judge(const MeasuredScenes& measured) {
  std::vector<Target> targets;
  judgeFrames(measured.frames, targets);
  judgeGrowth(measured.crowds, targets);
  const FrameCost& frame = measured.frame_on_threads;
  targets.push_back(judged(std::to_string(frame.bodies) + " moving bodies, whole frames", "one thread / two, wall time",
                           {{frame.serial_ns / frame.threads_ns, "5 % colliding"}}, {true, 1.7}));
  std::vector<Result> few, many;
  for (const Result& result : measured.layouts) (result.workload.vertices_moving <= 8 ? few : many).push_back(result);
  judgeQueries("a part of 5 to 8 vertices in a layout", few, 3, 8, targets);
  judgeQueries("a part of more vertices in a layout", many, 1.5, 8, targets);
  judgeQueries("a robot in a map of 10,000", measured.maps, 10, 10, targets);
  targets.push_back(judged(std::to_string(measured.batch.poses) + " poses", "one thread / two, wall time",
                           {{measured.batch.serial_ns / measured.batch.threads_ns, "countries"}}, {true, 1.8}));
  targets.push_back(judged(
      std::to_string(measured.fleet.robots) + " robots on splines, all conflicts",
      "swept boxes in Boost's rtree / scene",
      {{measured.fleet.swept_ms / measured.fleet.scene_ms, std::to_string(measured.fleet.conflicts) + " conflicts"}},
      {true, 3}));
  std::vector<Figure> rays;
  for (const Result& result : measured.rays) {
    rays.push_back({*fastest(result, Role::Rival) / *nsOf(result, "scene"), cellName(result)});
  }
  targets.push_back(judged("rays in a map of 10,000", "the faster of Box2D and Boost / scene", rays, {true, 3}));
  return targets;
}

}  // namespace tricover::bench
