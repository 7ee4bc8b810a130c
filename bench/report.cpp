// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <utility>

namespace tricover::bench {
namespace {

/// The faults in either direction of a workload's answers.
std::pair<std::string, std::string> faults(const Workload& workload) {
  const std::string& name = workload.name;
  if (workload.job == "distance" || name == "distance") return {"too short", "too long"};
  if (name == "sliding" || name == "turning") return {"too early", "too late or missed"};
  return {"false alarms", "misses"};
}

const char* const kConditions =
    R"(- All methods of a cell are interleaved at random in one process. What would take longer visits a part of the
  positions, evenly spread; methods with coherence visit them in runs of 100. Poses are converted before.
- Every timed answer is compared with that of `cold`, which the tests compare with exact arithmetic.
- cold: tricover's core without a PairCache; cached: with one; paper: the paper's Algorithm 3, repaired, with a
  MaskCache; plain signs: the core compiled with plain double signs, no filter, no exact stage.
- via FCL: unmodified fcl::collide on tricover's shape. empty: the same for a registered function that does nothing.
- A cell's best rival is the fastest of FCL's four, GEOS and Boost, whether right or wrong. Rivals start without any
  check that they don't make themselves; the one exception are boxes that decide which convex pieces FCL's solvers see.
- FCL MPR (libccd's, which is what FCL runs for GST_LIBCCD) and FCL GJK (its own, GST_INDEP, without the EPA that
  fcl::collide adds): on one prism a convex piece (GEOS's constrained Delaunay triangles, merged by Hertel and
  Mehlhorn); "guess": started from its last simplex, where there is coherence. FCL BVH: flat OBBRSS meshes of the same
  triangles. All four are called as FCL's own rows call them, which spares them fcl::collide's dispatch.
- GEOS: a prepared polygon, by the C++ interface; the one with more vertices is prepared, the other one's coordinates
  are rewritten in place. Boost: boost::geometry::intersects; the one with fewer vertices is rewritten in place.
- Distances: near and far are random poses whose regions are apart, the origins at 1.03 to 1.5 and 2 to 4 times their
  distance at contact. FCL RSS (OBBRSS is the same here): flat meshes with that volume, called without
  fcl::distance's dispatch; FCL GJK (libccd) and (indep) take convex polygons as prisms; GEOS prepared is
  PreparedGeometry::distance. GEOS (Geometry::distance) and Boost, which compare all edges with all, are left
  out above 4096 pairs of edges. Box2D: b2Distance; "warm" starts from its last simplex. An answer of a rival is wrong
  if it is off by more than 1e-6 of the polygons' size; cached and via FCL must give cold's to the last bit.
- Times of impact: sliding and turning (by up to 150 degrees) are random motions from near the fixed polygon, into it or
  past it. FCL RSS and OBBRSS: fcl::continuousCollide by conservative advancement on flat meshes, to which FCL gives a
  tolerance of 1e-5 of the motion; tricover is asked for the same. A rival's time is wrong if it is later than that, or
  earlier than contact by a thousandth of the motion. (Where a step of FCL's lands on the contact to the last bit it finds no
  direction there, and goes on: most of its misses.) Box2D: b2TimeOfImpact.
- Box2D: b2TestOverlap ("overlap") and b2CollidePolygons ("manifold"), one of our units being 64 of its metres, so that
  its skin is 3e-6 of the polygons' size.
- The packaged libfcl has asserts on and SSE off. All its templates on the rivals' ways are compiled here, with the
  flags above and without asserts; libccd, BVH nodes' accessors and the broadphase are the packaged ones.
- Round shapes: unmodified fcl::collide and fcl::distance between a polygon's prism and one
  and the same round body, which lies between the prism's ends; "swapped": it comes first. "FCL" has a Convex for the
  polygon; "FCL Box" is another form of 4 vertices, a rectangle. disc: PolygonShape(point, margin), in FCL's pairs a
  Sphere; 1 x 1 are two discs. libccd and indep are FCL's solvers. collide: about half of the poses collide; distance:
  apart.
)";

std::string table(const std::vector<Result>& results, const std::string& unit) {
  std::vector<std::string> methods;
  for (const Result& result : results) {
    for (const Timing& timing : result.timings) {
      const bool known = std::find(methods.begin(), methods.end(), timing.name) != methods.end();
      if (!known) methods.push_back(timing.name);
    }
  }
  bool sized = false, counted = false, checked = false;
  for (const Result& result : results) {
    sized = sized || result.workload.vertices_fixed > 0;
    counted = counted || result.collisions > 0;
    for (const Timing& timing : result.timings) checked = checked || timing.checked > 0;
  }
  std::vector<std::string> heads = {"workload"};
  if (sized) heads.push_back("vertices");
  if (counted) heads.push_back("collisions");
  const auto first = static_cast<std::ptrdiff_t>(heads.size());
  heads.insert(heads.end(), methods.begin(), methods.end());
  TextTable lines = {heads};
  std::string disagreements;
  for (const Result& result : results) {
    const Workload& workload = result.workload;
    lines.push_back({workload.scene + ", " + workload.name});
    if (sized)
      lines.back().push_back(std::to_string(workload.vertices_fixed) + " x " +
                             std::to_string(workload.vertices_moving));
    if (counted)
      lines.back().push_back(std::to_string(result.collisions) + " of " + std::to_string(workload.positions));
    lines.back().resize(heads.size(), "");
    for (const Timing& timing : result.timings) {
      const auto column = std::find(heads.begin() + first, heads.end(), timing.name) - heads.begin();
      lines.back()[static_cast<std::size_t>(column)] =
          timing.ns == 0 ? "0" : formatted(timing.ns < 100 ? "%.1f" : "%.0f", timing.ns);
      if (timing.false_alarms + timing.misses == 0) continue;
      const auto [low, high] = faults(workload);
      disagreements += "- " + cellName(workload) + ": " + timing.name + ": " + std::to_string(timing.false_alarms) +
                       " " + low + " and " + std::to_string(timing.misses) + " " + high + " in " +
                       std::to_string(timing.checked) + " queries\n";
    }
  }
  if (disagreements.empty()) disagreements = "- none\n";
  return unit + ":\n\n" + markdown(lines) +
         (checked ? "\nDisagreements with tricover's exact answers:\n" + disagreements : "");
}

bool oursAgree(const std::vector<Result>& results) {
  bool agree = true;
  for (const Result& result : results) {
    for (const Timing& timing : result.timings) {
      if (timing.role != Role::Ours || timing.false_alarms + timing.misses == 0) continue;
      std::fprintf(stderr, "error: %s disagrees with tricover cold on %s, %s\n", timing.name.c_str(),
                   result.workload.scene.c_str(), result.workload.name.c_str());
      agree = false;
    }
  }
  return agree;
}

std::string csv(const std::vector<Result>& results) {
  constexpr const char* kRoles[] = {"ours", "rival", "box2d", "empty", "inexact"};
  std::ostringstream out;
  out << "job,scene,workload,vertices_fixed,vertices_moving,queries,collisions,role,method,ns_per_query,"
         "checked,false_alarms,misses,decided_at_once\n";
  for (const Result& result : results) {
    const Workload& w = result.workload;
    for (const Timing& t : result.timings) {
      out << w.job << ',' << quotedField(w.scene) << ',' << quotedField(w.name) << ',' << w.vertices_fixed << ','
          << w.vertices_moving << ',' << w.positions << ',' << result.collisions << ','
          << kRoles[static_cast<int>(t.role)] << ",\"" << t.name << "\"," << formatted("%.6g", t.ns) << ',' << t.checked
          << ',' << t.false_alarms << ',' << t.misses << ',' << result.decided_at_once << '\n';
    }
  }
  return out.str();
}

}  // namespace

std::string markdown(const TextTable& lines) {
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
    for (std::size_t i = 0; i < widths.size(); ++i) {
      const std::string dashes(widths[i] + 1, '-');
      text += i == 0 ? "|:" + dashes + "|" : dashes + ":|";
    }
    text += "\n";
  }
  return text;
}

std::string shortNumber(double value) {
  char text[32];
  std::snprintf(text, sizeof text, std::abs(value) < 100 ? "%.3g" : "%.0f", value);
  return text;
}

void showProgress(std::size_t done, std::size_t total, const std::string& title) {
  if (!isatty(STDERR_FILENO)) return;
  std::fprintf(stderr, "\r\033[K[%zu/%zu] %s", done, total, title.c_str());
  if (done == total) std::fprintf(stderr, "\n");
}

std::string quotedField(const std::string& text) {
  return text.find(',') == std::string::npos ? text : '"' + text + '"';
}

std::string machine(const Settings& settings) {
  std::string cpu = "unknown processor";
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.rfind("model name", 0) == 0) cpu = line.substr(line.find(':') + 2);
    if (cpu != "unknown processor") break;
  }
  std::ostringstream out;
  out << "- Machine: " << cpu << ", " << std::thread::hardware_concurrency() << " processors; one thread is timed.\n"
      << "- Compiler: " << TRICOVER_BENCH_COMPILER << ", flags" << TRICOVER_BENCH_FLAGS << ".\n"
      << "- Rivals: " << TRICOVER_BENCH_RIVALS << ", as Debian packages them.\n"
      << "- Times: CPU time per query, the median of " << settings.repetitions << " repetitions of about "
      << settings.seconds_per_repetition << " s.\n";
  return out.str();
}

std::string conditions(const Settings& settings) { return machine(settings) + kConditions; }

std::string formatted(const char* format, double value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

void writeFile(const std::string& path, const std::string& content) {
  std::ofstream out(path, std::ios::binary);
  out << content;
  out.close();
  if (!out) throw std::runtime_error("cannot write " + path);
}

void writeBlocks(const std::string& path, const Blocks& blocks) {
  std::string text;
  for (const auto& [name, lines] : blocks) text += "# " + name + "\n" + lines + "\n\n";
  writeFile(path, text);
}

bool writeStudies(const std::string& directory, const std::string& name, const std::vector<Study>& studies,
                  const std::string& how, const std::string& unit) {
  std::string text;
  std::vector<Result> all;
  for (const auto& [title, results] : studies) {
    text += "# " + title + "\n\n" + table(results, unit) + "\n";
    all.insert(all.end(), results.begin(), results.end());
  }
  writeFile(directory + "/" + name + ".md", text + how);
  writeFile(directory + "/" + name + ".csv", csv(all));
  return oursAgree(all);
}

}  // namespace tricover::bench

int main(int argc, char** argv) {
  const bool full = argc == 3 && std::string(argv[2]) == "--full";
  if (argc != 2 && !full) {
    std::fprintf(stderr, "usage: %s <existing report directory> [--full]\n", argv[0]);
    return 2;
  }
  std::string interleave = "--benchmark_enable_random_interleaving=true";
  char* benchmark_arguments[] = {argv[0], interleave.data(), nullptr};
  int benchmark_count = 2;
  benchmark::Initialize(&benchmark_count, benchmark_arguments);
  try {
    return tricover::bench::run(argv[1], full) ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}
