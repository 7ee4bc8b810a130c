// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "report.h"
#include "studies.h"

namespace tricover::bench {
namespace {

/// The columns after the vertices: each draws the fastest of several methods.
using Columns = std::vector<std::vector<std::string>>;
const Columns kCollisions = {{"cold"},    {"cached"}, {"via FCL"}, {"FCL MPR", "FCL GJK", "FCL GJK guess"},
                             {"FCL BVH"}, {"GEOS"},   {"Boost"},   {"paper"}};
const Columns kValues = {{"cold"},
                         {"cached"},
                         {"via FCL"},
                         {"FCL GJK (libccd)", "FCL GJK (indep)", "FCL GJK (indep) guess"},
                         {"FCL RSS", "FCL OBBRSS"},
                         {"GEOS prepared", "GEOS"},
                         {"Boost"},
                         {"Box2D", "Box2D warm"}};

double fastest(const Result& result, const std::vector<std::string>& methods) {
  double ns = std::numeric_limits<double>::infinity();
  for (const Timing& timing : result.timings) {
    if (std::find(methods.begin(), methods.end(), timing.name) != methods.end()) ns = std::min(ns, timing.ns);
  }
  return ns;
}

/// A block a kind and workload.
std::string blockName(const Workload& workload) { return workload.scene + " " + workload.name; }

/// Only cells of equally many vertices.
Blocks timesOf(const std::vector<Result>& results, const Columns& columns) {
  Blocks blocks;
  for (const Result& result : results) {
    const Workload& w = result.workload;
    if (w.vertices_fixed != w.vertices_moving) continue;
    std::ostringstream line;
    line << w.vertices_fixed;
    for (const auto& methods : columns) line << ' ' << fastest(result, methods);
    blocks[blockName(w)] += line.str() + "\n";
  }
  return blocks;
}

}  // namespace

void writePlotData(const std::vector<Result>& study, const std::vector<Result>& distances,
                   const std::vector<Result>& impacts, const std::string& directory) {
  writeBlocks(directory + "/times.dat", timesOf(study, kCollisions));
  writeBlocks(directory + "/distance.dat", timesOf(distances, kValues));
  writeBlocks(directory + "/impact.dat", timesOf(impacts, kValues));
  Blocks grid;
  for (const Result& result : study) {
    const Workload& w = result.workload;
    const double cached = fastest(result, {"cached"});
    const double ours = std::isfinite(cached) ? cached : fastest(result, {"cold"});
    double rival = std::numeric_limits<double>::infinity();
    for (const Timing& timing : result.timings)
      if (timing.role == Role::Rival) rival = std::min(rival, timing.ns);
    std::ostringstream line;
    line << w.vertices_fixed << ' ' << w.vertices_moving << ' ' << ours << ' ' << rival << ' ' << rival / ours << '\n';
    // A blank line between the rows of a surface; cells come row by row.
    if (w.vertices_moving == 1024) line << '\n';
    grid[blockName(w)] += line.str();
  }
  writeBlocks(directory + "/grid.dat", grid);
}

}  // namespace tricover::bench
