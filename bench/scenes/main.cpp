// SPDX-License-Identifier: BSD-3-Clause
// Scenes beside what people use for them: many against many, one against many, rays, conflicts of a fleet, and what it
// all costs.
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>

#include "one_to_many.h"
#include "report.h"
#include "scene_pictures.h"
#include "scene_targets.h"
#include "tricover_fcl/tricover_fcl.h"

namespace tricover::bench {
namespace {

const char* const kHow =
    R"(- As in the other tables: all methods of a row are interleaved at random in one process, and every timed answer is
  compared with that of `cold`: the core, where one asks many behind a scan of all boxes, where many ask many behind
  FCL's manager.
- Frames: 2,000 outlines on circles of their own; every one is moved, then all pairs that collide are wanted. All methods
  walk 50 frames forth and back. via FCL: our shapes, fcl::collide deciding the pairs of DynamicAABBTreeCollisionManager;
  "array tree", "SSaP", "interval tree", "hash": of FCL's other managers (its SaP loses pairs or hangs after turns); tight
  boxes: PolygonObjects under the first; SceneManager: ours. FCL BVH: flat OBBRSS meshes under the first. Box2D: b2BroadPhase, told of the motion so that it can look ahead; pairs
  are kept while their grown boxes meet, as in a b2World, and b2TestOverlap decides. It counts as touching what is closer
  than 0.02 of its units: "Box2D" has one of them for one of ours (outlines are 100 across), the others 64, 0.1 and
  0.01.
- Layouts: 80 parts of a dozen kinds, bottom-left fill. Eight of them in turn are taken out and placed anew: free (close
  to their own place, without a collision), local (around it by a fifth of the size), uniform (anywhere, turned anyhow).
- Maps: 10,000 obstacles and a fork lift of 12 vertices; a planner's path goes from free poses in small steps until it
  arrives or collides. "scene, cached" has a SceneCache.
- GEOS STRtree: TemplateSTRtree over prepared geometries, the query's coordinates rewritten in place, left at the first
  hit. Boost rtree: packed, boost::geometry::intersects, left at the first hit.
- Rays: 360 from each of some free poses, 1,000 units long; a query is one ray. Box2D: b2DynamicTree, a b2PolygonShape a rack,
  the edges of a b2ChainShape a country. Boost: rtree of all edges. cold: castRay() of every body near the ray.
)";

std::string ns(double value) { return shortNumber(value) + " ns"; }

std::string costsTables(const MeasuredScenes& measured) {
  TextTable crowds = {{"bodies", "a moving body, all moving", "1 % moving", "to build, a body", "bytes a body"}};
  for (const CrowdCost& cost : measured.crowds) {
    crowds.push_back({std::to_string(cost.bodies), ns(cost.all_moving_ns), ns(cost.few_moving_ns), ns(cost.build_ns),
                      shortNumber(cost.bytes)});
  }
  TextTable maps = {{"a map of 10,000 countries", "to build, an obstacle", "bytes an obstacle"}};
  for (const MapCost& cost : measured.map_costs)
    maps.push_back({cost.method, ns(cost.build_ns), shortNumber(cost.bytes)});
  const BatchCost& batch = measured.batch;
  const TextTable poses = {{"poses", "one by one", "at once", "at once, two threads", "same answers"},
                           {std::to_string(batch.poses), ns(batch.one_by_one_ns), ns(batch.serial_ns),
                            ns(batch.threads_ns), batch.same ? "yes" : "**no**"}};
  const FrameCost& frame = measured.frame_on_threads;
  const TextTable frames = {
      {"bodies that all move", "a body and frame", "two threads", "same pairs"},
      {std::to_string(frame.bodies), ns(frame.serial_ns), ns(frame.threads_ns), frame.same ? "yes" : "**no**"}};
  const FleetCost& fleet = measured.fleet;
  const TextTable conflicts = {
      {"robots", "obstacles", "conflicts", "scene: ms", "swept boxes: ms", "longest difference of times"},
      {std::to_string(fleet.robots), std::to_string(fleet.obstacles), std::to_string(fleet.conflicts),
       shortNumber(fleet.scene_ms), shortNumber(fleet.swept_ms), shortNumber(fleet.longest_difference)}};
  return "# What it costs\n\n" + markdown(crowds) + "\n" + markdown(frames) + "\n" + markdown(maps) + "\n" +
         markdown(poses) + "\n" + markdown(conflicts) +
         "\n- A crowd's frame and what is built: CPU time of one thread; memory is the heap's, without what belongs to "
         "the polygons and is\n  shared. Poses and frames on threads: wall time, oneTBB's parallel_for as the "
         "Parallel. Conflicts: of robots "
         "on cubic splines with each other\n  and with obstacles, each with its first time; the rival asks "
         "timeOfImpact() of every pair whose swept boxes meet.\n";
}

std::vector<Result> writeReport(const MeasuredScenes& measured, const Settings& settings,
                                const std::string& directory) {
  const std::vector<Target> targets = judge(measured);
  std::vector<Result> frames;
  std::string colliding;
  for (const FramesResult& of_kind : measured.frames) {
    frames.push_back(of_kind.result);
    colliding += "- " + of_kind.result.workload.scene + ": " + shortNumber(100 * of_kind.colliding) +
                 " % of the outlines collide with another one\n";
  }
  const std::string summary = "# Targets of scenes\n\n" + targetsTable(targets) + "\n";
  const std::string costs = costsTables(measured);
  std::fputs((summary + costs).c_str(), stdout);
  writeFile(directory + "/scene_targets.md", summary);
  writeFile(directory + "/scene_targets.csv", targetsCsv(targets));
  writeFile(directory + "/scene_costs.md", costs);
  writeFile(directory + "/scenes.md", "# Frames\n\n" + table(frames) + colliding + "\n# Layouts\n\n" +
                                          table(measured.layouts) + "\n# Maps\n\n" + table(measured.maps) +
                                          "\n# Rays\n\n" + table(measured.rays) + "\n# How it was measured\n\n" +
                                          machine(settings) + kHow);
  std::vector<Result> all = frames;
  for (const auto* results : {&measured.layouts, &measured.maps, &measured.rays}) {
    all.insert(all.end(), results->begin(), results->end());
  }
  writeFile(directory + "/scenes.csv", csv(all));
  return all;
}

int run(const std::string& data, const std::string& directory, bool full) {
  tricover_fcl::registerNarrowphase();
  std::ifstream in(data);
  if (!in) throw std::runtime_error("cannot read " + data);
  const Countries countries = readCountries(in);
  const Settings settings = full ? Settings{5, 0.1} : Settings{3, 0.01};
  constexpr std::size_t kSteps = 8;
  std::size_t done = 0;
  const auto begin = [&](const char* title) { showProgress(done++, kSteps, title); };
  MeasuredScenes measured;
  begin("pictures of scenes");
  drawScenes(countries, directory);
  begin("frames");
  measured.frames = measureFrames(settings, full);
  begin("layouts");
  measured.layouts = measureLayouts(settings, full);
  begin("maps");
  measured.maps = measureMaps(countries, settings, full);
  begin("rays");
  measured.rays = measureRays(countries, settings);
  begin("growing crowds, and what is built");
  measured.crowds = measureCrowdCosts();
  measured.frame_on_threads = measureFrameOnThreads();
  measured.map_costs = measureMapCosts(countries);
  begin("many poses");
  measured.batch = measureBatch(countries, full);
  begin("a fleet on splines");
  measured.fleet = measureFleet(full);
  showProgress(kSteps, kSteps, "done");
  const bool agree = oursAgree(writeReport(measured, settings, directory));
  // Both times may be early by the time_error.
  return agree && measured.batch.same && measured.frame_on_threads.same && measured.fleet.longest_difference <= 1e-6
             ? 0
             : 1;
}

}  // namespace
}  // namespace tricover::bench

int main(int argc, char** argv) { return tricover::bench::runStudy(argc, argv, tricover::bench::run); }
