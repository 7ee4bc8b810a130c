// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace tricover::bench {
namespace {

std::string rounded(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string vertices(const Workload& workload) {
  return std::to_string(workload.vertices_fixed) + " x " + std::to_string(workload.vertices_moving);
}

/// Rounded down, so that 100 means all.
std::string agreement(const Timing& timing) {
  const std::size_t wrong = timing.false_alarms + timing.misses;
  if (wrong == 0) return "100";
  const double share = 1 - static_cast<double>(wrong) / static_cast<double>(timing.checked);
  return rounded(static_cast<double>(static_cast<long>(1e5 * share)) / 1e3, 3);
}

using Lines = std::vector<std::vector<std::string>>;

/// Markdown that is aligned enough to be read as it is.
std::string aligned(const Lines& lines) {
  std::vector<std::size_t> widths(lines.front().size(), 0);
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  }
  std::string text;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    for (std::size_t i = 0; i < widths.size(); ++i) {
      const std::string padding(widths[i] - lines[l][i].size(), ' ');
      text += i == 0 ? "| " + lines[l][i] + padding : " | " + padding + lines[l][i];
    }
    text += " |\n";
    if (l > 0) continue;
    for (std::size_t i = 0; i < widths.size(); ++i) text += (i == 0 ? "|:" : ":|-") + std::string(widths[i], '-');
    text += ":|\n";
  }
  return text;
}

}  // namespace

std::string table(const std::vector<Result>& results, const std::string& job) {
  Lines lines;
  std::string disagreements;
  for (const Result& result : results) {
    const Workload& workload = result.workload;
    if (workload.job != job) continue;
    if (lines.empty()) {
      lines.push_back({"workload", "vertices", "queries", "collisions"});
      for (const Timing& timing : result.timings) lines[0].push_back(timing.name + " ns");
      for (const Timing& timing : result.timings) {
        if (timing.role == Role::Rival) lines[0].push_back(timing.name + " agrees %");
      }
    }
    const std::string name = workload.scene + ", " + workload.trajectory;
    lines.push_back({name, vertices(workload), std::to_string(workload.positions), std::to_string(result.collisions)});
    for (const Timing& timing : result.timings) lines.back().push_back(rounded(timing.ns, timing.ns < 100 ? 1 : 0));
    for (const Timing& timing : result.timings) {
      if (timing.role == Role::Rival) lines.back().push_back(agreement(timing));
      if (timing.false_alarms + timing.misses == 0) continue;
      disagreements += "- " + name + ", " + vertices(workload) + ": " + timing.name + ": " +
                       std::to_string(timing.false_alarms) + " false alarms and " + std::to_string(timing.misses) +
                       " misses in " + std::to_string(timing.checked) + " queries\n";
    }
  }
  if (lines.empty()) return "";
  if (disagreements.empty()) disagreements = "- none\n";
  return aligned(lines) + "\nDisagreements with tricover's exact answers:\n" + disagreements;
}

std::string csv(const std::vector<Result>& results) {
  std::ostringstream out;
  out << "job,scene,trajectory,vertices_fixed,vertices_moving,queries,collisions,method,ns_per_query,checked,"
         "false_alarms,misses\n";
  for (const Result& result : results) {
    const Workload& w = result.workload;
    for (const Timing& t : result.timings) {
      out << w.job << ',' << w.scene << ',' << w.trajectory << ',' << w.vertices_fixed << ',' << w.vertices_moving << ','
          << w.positions << ',' << result.collisions << ',' << t.name << ',' << rounded(t.ns, 2) << ',' << t.checked << ','
          << t.false_alarms << ',' << t.misses << '\n';
    }
  }
  return out.str();
}

std::string conditions(const Settings& settings) {
  std::string cpu = "unknown processor";
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.rfind("model name", 0) == 0) cpu = line.substr(line.find(':') + 2);
    if (cpu != "unknown processor") break;
  }
  std::ostringstream out;
  out << "- Machine: " << cpu << ", " << std::thread::hardware_concurrency() << " processors; one thread is timed.\n"
      << "- Compiler: " << TRICOVER_BENCH_COMPILER << ", flags " << TRICOVER_BENCH_FLAGS << ".\n"
      << "- Times: nanoseconds of CPU time per query; the median of " << settings.repetitions << " repetitions of at least "
      << settings.seconds_per_repetition << " s each, all methods interleaved at random in one process. Methods "
      << "without coherence may be timed on every k-th position, evenly spread; coherent ones walk all of them.\n"
      << "- Every timed answer is compared with tricover's cold answer, which the test suite compares with exact arithmetic.\n"
      << "- tricover cold: the core without a PairCache; cached: with one; in FCL: unmodified fcl::collide. paper cached: "
      << "Algorithm 3 as printed, with its repairs, and a PairCache.\n"
      << "- FCL GJK: one prism a convex piece (GEOS's constrained Delaunay triangles, merged by Hertel and Mehlhorn), moving ones "
      << "twice as high as fixed ones because FCL's MPR errs on equal heights. libccd is what FCL calls GST_LIBCCD (MPR), indep is "
      << "FCL's own GJK without the EPA that fcl::collide adds.\n"
      << "- FCL BVH: flat OBBRSS meshes of the same triangles, through fcl::collide.\n"
      << "- Paper's workloads: all methods, ours and the rivals, test the bounding discs first; then the pieces' boxes decide "
      << "which prisms GJK sees, and the solvers are called directly, without fcl::collide's dispatch.\n"
      << "- Countries: a query is one position of the moving country against all others. In FCL: "
      << "DynamicAABBTreeCollisionManager finds the pairs and unmodified fcl::collide decides them; every prism is an object of its "
      << "own, and pairs with a country that is hit already are skipped. The core methods have no broadphase and ask about "
      << "every country.\n"
      << "- The packaged libfcl has asserts on and SSE off. GJK, MPR's support functions and the mesh traversal are compiled "
      << "here with the flags above (no asserts); libccd and FCL's broadphase are the packaged ones.\n"
      << "- two spheres: fcl::collide on two spheres that don't meet; the floor of what a call costs.\n";
  return out.str();
}

void writePlotData(const std::vector<Result>& results, const std::string& directory) {
  // times.dat: one gnuplot block for each kind and trajectory, polygons of equally many vertices.
  std::map<std::string, std::string> blocks;
  std::string grid;
  for (const Result& result : results) {
    const Workload& w = result.workload;
    if (w.job != "paper") continue;
    std::string times;
    for (const Timing& timing : result.timings) times += " " + rounded(timing.ns, 2);
    if (w.vertices_fixed == w.vertices_moving) {
      blocks[w.scene + " " + w.trajectory] += std::to_string(w.vertices_fixed) + times + "\n";
    }
    if (w.scene == "contour" && w.trajectory == "circular") {
      grid += std::to_string(w.vertices_fixed) + " " + std::to_string(w.vertices_moving) + times + "\n";
    }
  }
  std::string times;
  for (const auto& [name, lines] : blocks) times += "\"" + name + "\"\n" + lines + "\n\n";
  writeFile(directory + "/times.dat", times);
  writeFile(directory + "/grid.dat", grid);
}

void writeFile(const std::string& path, const std::string& content) {
  std::ofstream out(path, std::ios::binary);
  out << content;
  out.close();
  if (!out) throw std::runtime_error("cannot write " + path);
}

}  // namespace tricover::bench
