// SPDX-License-Identifier: BSD-3-Clause
// Scenes of bodies at rest: maps of millions, and layouts in their containers. Needs no FCL.
#include <cstdlib>
#include <string>
#include <vector>

#include "containers.h"
#include "measure.h"
#include "report.h"
#include "still_maps.h"

namespace tricover::bench {
namespace {

std::string mapTable(const std::vector<StillMapCost>& costs) {
  TextTable lines = {{"8-gons", "method", "bytes a body", "made and added: ns a body", "collides, the first time: ns",
                      "collides: ns", "nearest to a hexagon: ns", "to a point: ns", "answers"}};
  for (const StillMapCost& cost : costs)
    lines.push_back({std::to_string(cost.bodies), cost.method, shortNumber(cost.bytes), shortNumber(cost.build_ns),
                     shortNumber(cost.first_ns), shortNumber(cost.collides_ns), shortNumber(cost.hexagon_ns),
                     shortNumber(cost.point_ns), formatted("%.12g", cost.answers)});
  return markdown(lines);
}

std::string containerTable(const std::vector<ContainerCost>& costs) {
  TextTable lines = {{"parts, vertices", "placed", "collide", "scan: ns", "Scene: ns", "cached: ns", "scan / Scene"}};
  for (const ContainerCost& cost : costs)
    lines.push_back({cost.parts, cost.placing, formatted("%.2f", cost.hits), shortNumber(cost.scan_ns),
                     shortNumber(cost.scene_ns), shortNumber(cost.cached_ns),
                     formatted("%.2f", cost.scan_ns / cost.scene_ns)});
  return markdown(lines);
}

std::string nearestTable(const std::vector<NearestCost>& costs) {
  TextTable lines = {{"polygon, poses", "nearest: ns", "with a SceneCache: ns"}};
  for (const NearestCost& cost : costs)
    lines.push_back({cost.walk, shortNumber(cost.none_ns), shortNumber(cost.cached_ns)});
  return markdown(lines);
}

int run(const std::string& directory, std::size_t bodies) {
  const std::vector<ContainerCost> containers = measureContainers();
  const std::vector<StillMapCost> maps = measureStillMaps(bodies);
  std::vector<Target> targets = judgeStillMaps(maps);
  for (Target& target : judgeContainers(containers)) targets.push_back(std::move(target));
  const std::vector<NearestCost> nearest = measureNearest();
  for (Target& target : judgeNearest(nearest)) targets.push_back(std::move(target));
  const std::string text =
      "# Still maps\n\n" + mapTable(maps) + "\n# Layouts in their containers\n\n" + containerTable(containers) +
      "\n# The nearest of 10,000 bodies\n\n" + nearestTable(nearest) + "\n" + targetsTable(targets) +
      "\n- CPU time of one thread. Maps: once, each method in a map of its own, the polygons' data included. "
      "Containers: "
      "medians,\n  methods in turn; eight parts are taken out and placed anew. The scan looks at all boxes, asks "
      "collide() where they meet,\n  and looks at the container where a box leaves its hole alone.\n";
  std::fputs(text.c_str(), stdout);
  writeFile(directory + "/still.md", text);
  writeFile(directory + "/still_targets.csv", targetsCsv(targets));
  bool same = true;
  for (const ContainerCost& cost : containers) same = same && cost.same;
  return same ? 0 : 1;
}

}  // namespace
}  // namespace tricover::bench

int main(int argc, char** argv) {
  using namespace tricover::bench;
  const std::size_t bodies = argc == 3 ? std::strtoul(argv[2], nullptr, 10) : 1000000;
  return runProgram(argv[0], "<existing report directory> [bodies of the largest map: 1000000]",
                    (argc == 2 || argc == 3) && bodies > 0, [&] { return run(argv[1], bodies); });
}
