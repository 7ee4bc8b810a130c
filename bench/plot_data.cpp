// SPDX-License-Identifier: BSD-3-Clause
#include "plot_data.h"

#include <algorithm>
#include <limits>
#include <map>
#include <sstream>

#include "report.h"

namespace tricover::bench {
namespace {

/// The columns of times.dat after the vertices; of several methods the fastest.
const std::vector<std::vector<std::string>> kColumns = {
    {"cold"},    {"cached"}, {"via FCL"}, {"FCL MPR", "FCL GJK", "FCL GJK guess"},
    {"FCL BVH"}, {"GEOS"},   {"Boost"},   {"paper"}};

double fastest(const Result& result, const std::vector<std::string>& methods) {
  double ns = std::numeric_limits<double>::infinity();
  for (const Timing& timing : result.timings) {
    if (std::find(methods.begin(), methods.end(), timing.name) != methods.end()) ns = std::min(ns, timing.ns);
  }
  return ns;
}

}  // namespace

void writePlotData(const std::vector<Result>& results, const std::string& directory) {
  // A block of gnuplot's a kind and workload, which is its name.
  std::map<std::string, std::ostringstream> times, grid;
  for (const Result& result : results) {
    const Workload& w = result.workload;
    const std::string name = w.scene + " " + w.name;
    if (w.vertices_fixed == w.vertices_moving) {
      times[name] << w.vertices_fixed;
      for (const auto& methods : kColumns) times[name] << ' ' << fastest(result, methods);
      times[name] << '\n';
    }
    const double cached = fastest(result, {"cached"}), cold = fastest(result, {"cold"});
    double rival = std::numeric_limits<double>::infinity();
    for (const Timing& timing : result.timings) {
      if (timing.role == Role::Rival) rival = std::min(rival, timing.ns);
    }
    const double ours = cached < std::numeric_limits<double>::infinity() ? cached : cold;
    grid[name] << w.vertices_fixed << ' ' << w.vertices_moving << ' ' << ours << ' ' << rival << ' ' << rival / ours
               << '\n';
    // A blank line between the rows of a surface; cells come row by row.
    if (w.vertices_moving == 1024) grid[name] << '\n';
  }
  const auto written = [](const auto& blocks) {
    std::string text;
    for (const auto& [name, lines] : blocks) text += "# " + name + "\n" + lines.str() + "\n\n";
    return text;
  };
  writeFile(directory + "/times.dat", written(times));
  writeFile(directory + "/grid.dat", written(grid));
}

}  // namespace tricover::bench
