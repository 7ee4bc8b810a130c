// SPDX-License-Identifier: BSD-3-Clause
// The floors' table: reads the CSV files that the other programs left in the report directory, takes each row's figure
// from them, and puts the figure beside its floor. Writes floors.csv and floors.md there.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "measure.h"
#include "report.h"

namespace tricover::bench {
namespace {

/// All workloads, and what each method took.
using Cells = std::vector<Result>;

std::vector<std::string> fieldsOf(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

Role roleOf(const std::string& name) {
  return name == "ours" ? Role::Ours : name == "rival" ? Role::Rival : name == "box2d" ? Role::Box2d : Role::Floor;
}

/// Appends what report.h's csv() wrote; nothing if there is no such file.
void readCells(const std::string& path, Cells& cells) {
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    const std::vector<std::string> f = fieldsOf(line);
    if (f.size() < 14) continue;
    const auto number = [&](std::size_t i) {
      return static_cast<std::size_t>(std::strtoull(f[i].c_str(), nullptr, 10));
    };
    const Workload workload{f[0], f[1], f[2], number(3), number(4), number(5), 1};
    const auto same = [](const Workload& p, const Workload& q) {
      return p.job == q.job && cellName(p) == cellName(q) && p.positions == q.positions;
    };
    if (cells.empty() || !same(cells.back().workload, workload)) cells.push_back({workload, number(6), {}, number(13)});
    cells.back().timings.push_back({f[8], roleOf(f[7]), std::strtod(f[9].c_str(), nullptr), 0, 0, 0});
  }
}

/// A figure of a cell, by a method's time or by several; nothing if the cell has no such method.
using Ns = std::function<std::optional<double>(const Result&)>;
using Holds = std::function<bool(const Workload&)>;

/// The least time of the timings that `wanted` names.
template <class Wanted>
Ns least(Wanted wanted) {
  return [=](const Result& result) {
    std::optional<double> ns;
    for (const Timing& timing : result.timings)
      if (wanted(timing) && (!ns || timing.ns < *ns)) ns = timing.ns;
    return ns;
  };
}
Ns method(const std::string& name) {
  return least([=](const Timing& timing) { return timing.name == name; });
}
Ns startsWith(const std::string& start) {
  return least([=](const Timing& timing) { return timing.name.rfind(start, 0) == 0; });
}
Ns fastest(Role role) {
  return least([=](const Timing& timing) { return timing.role == role; });
}
/// The core as the workload has it used: with a PairCache where there is coherence.
std::optional<double> core(const Result& result) {
  const auto cached = method("cached")(result);
  return cached ? cached : method("cold")(result);
}
/// The same number for every cell, so that a time itself can be a row: 1e3 makes microseconds of it.
Ns constant(double ns) {
  return [=](const Result&) { return std::optional<double>(ns); };
}
/// FCL's best solver of those that are called directly.
const Ns kFclSolver =
    least([](const Timing& timing) { return timing.role == Role::Rival && timing.name.rfind("FCL", 0) == 0; });
/// A query through FCL, in the slower order of its operands.
std::optional<double> slowerOrder(const Result& result) {
  const auto one = method("via FCL")(result), other = method("via FCL, swapped")(result);
  return one && other ? std::max(*one, *other) : one;
}

Holds job(const std::string& name) {
  return [=](const Workload& w) { return w.job == name; };
}
Holds operator&&(const Holds& p, const Holds& q) {
  return [=](const Workload& w) { return p(w) && q(w); };
}
/// The workload's name, or the scene's, begins so.
Holds named(const std::string& start) {
  return [=](const Workload& w) { return w.name.rfind(start, 0) == 0; };
}
Holds on(const std::string& start) {
  return [=](const Workload& w) { return w.scene.rfind(start, 0) == 0; };
}
Holds sized(std::size_t low, std::size_t high) {
  return [=](const Workload& w) { return w.vertices_fixed >= low && w.vertices_fixed <= high; };
}
Holds notNamed(const std::string& start) {
  return [=](const Workload& w) { return w.name.rfind(start, 0) != 0; };
}

struct Figure {
  double value;
  std::string cell;
};
using Figures = std::vector<Figure>;
using Take = std::function<Figures(const Cells&)>;

/// `above` / `below` of every cell that `holds` names and that has both.
Take ratios(Holds holds, Ns above, Ns below) {
  return [=](const Cells& cells) {
    Figures figures;
    for (const Result& cell : cells) {
      if (!holds(cell.workload)) continue;
      const auto p = above(cell), q = below(cell);
      if (p && q) figures.push_back({*p / *q, cellName(cell.workload)});
    }
    return figures;
  };
}

/// `fcl::collide` beside FCL's best solver, where its first box or support tells most queries, or elsewhere.
Take throughFcl(bool at_once) {
  return [=](const Cells& cells) {
    Figures figures;
    for (const Result& cell : cells) {
      const auto ours = method("via FCL")(cell), theirs = kFclSolver(cell);
      if (cell.workload.job == "study" && ours && theirs &&
          (2 * cell.decided_at_once > cell.workload.positions) == at_once)
        figures.push_back({*theirs / *ours, cellName(cell.workload)});
    }
    return figures;
  };
}

/// The power of a size with which `ns` grows from the least to the largest cell that `holds` names, for each scene and
/// workload: of equally many vertices, at least 64 (fewer have paths of their own), or of islands and a robot of 4.
Take growth(Holds holds, Ns ns) {
  return [=](const Cells& cells) {
    std::map<std::string, std::pair<const Result*, const Result*>> ends;
    for (const Result& cell : cells) {
      const Workload& w = cell.workload;
      if (!holds(w) || !ns(cell) || (w.job != "islands" && w.vertices_fixed != w.vertices_moving) ||
          w.vertices_fixed < 64)
        continue;
      auto& [low, high] = ends.try_emplace(w.scene + ", " + w.name, &cell, &cell).first->second;
      if (w.vertices_fixed < low->workload.vertices_fixed) low = &cell;
      if (w.vertices_fixed > high->workload.vertices_fixed) high = &cell;
    }
    Figures figures;
    for (const auto& [name, pair] : ends) {
      const auto& [low, high] = pair;
      if (low == high) continue;
      const double more =
          static_cast<double>(high->workload.vertices_fixed) / static_cast<double>(low->workload.vertices_fixed);
      figures.push_back({std::log(*ns(*high) / *ns(*low)) / std::log(more), name});
    }
    return figures;
  };
}

/// The longest of a cell's times.
std::optional<double> longest(const Result& result) {
  double most = 0;
  for (const Timing& timing : result.timings) most = std::max(most, timing.ns);
  return most;
}

/// Penetration of deep contours beside f8f33f8's: that commit took `reference` times as long as GEOS's overlay of the
/// same regions, which is measured again in every run, so that the figure hardly depends on the machine.
Take besidePenetrationBefore(std::size_t vertices, double reference) {
  const Holds holds = job("detail") && on("contour") && named("deep") && sized(vertices, vertices);
  return ratios(
      holds, [=](const Result& cell) { return std::optional<double>(reference * *method("GEOS overlay")(cell)); },
      method("penetration"));
}

/// One row of the table. A floor is the least value that is accepted, or the largest where `at_least` is false.
struct Floor {
  const char* subject;
  const char* compared;  ///< how the figure is taken
  const char* before;    ///< what 0.3.0 had at f8f33f8
  double floor;
  bool at_least;
  enum { Worst, Median } of;
  const char* unit;
  Take take;
};

constexpr bool kAtLeast = true, kAtMost = false;
/// Penetration / GEOS overlay at f8f33f8, the median of three runs: 0.493 to 0.505, 3.28 to 3.38.
constexpr double kPenetration64 = 0.50, kPenetration512 = 3.35;

/// Section 6 of the design, in its order.
std::vector<Floor> allFloors() {
  const Ns rival = fastest(Role::Rival), box2d = fastest(Role::Box2d), cold = method("cold"), scene = method("scene");
  const Holds study = job("study"), distances = job("distance") && notNamed("overlap"), first = job("first");
  const Take best = ratios(study, rival, core), distance = ratios(distances, rival, cold),
             warm = ratios(distances, box2d, core);
  const Ns ours = method("tricover"), v3 = method("Box2D v3");
  const char* const rival_core = "the best of FCL, GEOS, Boost / core";
  const auto cache = [&](const char* query) {
    return ratios(job("cache") && named(query), method("cached"), method("none"));
  };
  const auto made = [&](std::size_t low, std::size_t high) { return ratios(first && sized(low, high), rival, ours); };
  const auto beside_v3 = [&](const char* query) { return ratios(job("Box2D v3") && named(query), v3, ours); };
  const auto layout = [&](const char* name) { return ratios(job("layout"), startsWith(name), scene); };
  const auto map = [&](const char* name) { return ratios(job("map"), startsWith(name), scene); };
  const auto round = [&](const char* query) { return ratios(job("round") && named(query), rival, slowerOrder); };
  const auto gap = [&](const char* query) {
    return ratios(job("gap") && named(query), method("gap 1e-12"), method("gap 0.001"));
  };
  const auto still = [&](const char* name, double unit) {
    return ratios(job("still map") && named(name), scene, constant(unit));
  };
  const auto detail = [&](const char* name) { return ratios(job("detail"), method(name), method("crossings")); };
  return {
      {"collide, all cells", rival_core, "1.6", 1.2, kAtLeast, Floor::Worst, "x", best},
      {"collide, all cells", rival_core, "13.3", 8, kAtLeast, Floor::Median, "x", best},
      {"collide, convex and slim 8", "Box2D 2.4 / core", "2.0", 1.3, kAtLeast, Floor::Worst, "x",
       ratios(study, box2d, core)},
      {"fcl::collide where FCL's first box or support tells most queries", "FCL's best solver / via FCL", "0.54", 0.5,
       kAtLeast, Floor::Worst, "x", throughFcl(true)},
      {"fcl::collide elsewhere", "FCL's best solver / via FCL", "1.5", 1.3, kAtLeast, Floor::Worst, "x",
       throughFcl(false)},
      {"made and asked 1 to 100 times, 4 vertices", "best library / core", "2.3", 1.2, kAtLeast, Floor::Worst, "x",
       made(4, 4)},
      {"made and asked, 8 vertices", "best library / core", "2.5", 1.5, kAtLeast, Floor::Worst, "x", made(8, 8)},
      {"made and asked, 24 to 1,024 vertices", "best library / core", "3.5", 2, kAtLeast, Floor::Worst, "x",
       made(24, 1024)},
      {"soups, needles, overlapping rings", "FCL BVH / core", "2.6", 1.5, kAtLeast, Floor::Worst, "x",
       ratios(job("soups"), rival, core)},
      {"distance without a cache", rival_core, "1.5", 1, kAtLeast, Floor::Worst, "x", distance},
      {"distance without a cache", rival_core, "8.5", 5, kAtLeast, Floor::Median, "x", distance},
      {"distance, convex and slim 8", "Box2D from its last simplex / core", "0.60", 0.5, kAtLeast, Floor::Worst, "x",
       warm},
      {"distance, convex and slim 8", "Box2D from its last simplex / core", "0.88", 0.7, kAtLeast, Floor::Median, "x",
       warm},
      {"time of impact", "FCL's advancement / core", "11.6", 5, kAtLeast, Floor::Worst, "x",
       ratios(job("impact"), rival, core)},
      {"time of impact, convex and slim 8", "Box2D 2.4, its cast where nothing rotates / core", "3.0", 1, kAtLeast,
       Floor::Worst, "x", ratios(job("impact"), box2d, core)},
      {"beside Box2D v3: slides", "b2ShapeCast / core", "1.1", 0.6, kAtLeast, Floor::Worst, "x",
       beside_v3("slides, b2ShapeCast")},
      {"beside Box2D v3: rotates", "b2TimeOfImpact / core", "0.66", 0.5, kAtLeast, Floor::Worst, "x",
       beside_v3("rotates")},
      {"beside Box2D v3: distance", "b2ShapeDistance / core", "0.63", 0.5, kAtLeast, Floor::Worst, "x",
       beside_v3("distance")},
      {"beside Box2D v3: nearest of 10,000", "a descent of its tree / Scene", "1.1", 0.9, kAtLeast, Floor::Worst, "x",
       beside_v3("nearest")},
      {"contact of resting and sliding 8-gons", "Box2D's manifold / core", "0.79", 0.5, kAtLeast, Floor::Worst, "x",
       ratios(job("contacts"), box2d, cold)},
      {"polygon and round shape through FCL, collide", "FCL's own pair / via FCL, the slower order", "0.88", 0.7,
       kAtLeast, Floor::Worst, "x", round("collide")},
      {"polygon and round shape through FCL, distance", "FCL's own pair / via FCL, the slower order", "0.48", 0.4,
       kAtLeast, Floor::Worst, "x", round("distance")},
      {"2,000 moving outlines, whole frames", "BVH meshes in FCL's best manager / Scene", "3.1", 2, kAtLeast,
       Floor::Worst, "x", ratios(job("frames") && on("contour"), method("FCL BVH"), scene)},
      {"2,000 moving 8-gons, whole frames", "Box2D at its best scale / Scene", "2.8", 1.8, kAtLeast, Floor::Worst, "x",
       ratios(job("frames") && on("convex"), box2d, scene)},
      {"a part in a layout of 80", "core behind a scan of boxes / Scene", "1.1", 0.85, kAtLeast, Floor::Worst, "x",
       layout("cold")},
      {"a part in a layout of 80", "GEOS STRtree, prepared / Scene", "4.2", 3, kAtLeast, Floor::Worst, "x",
       layout("GEOS")},
      {"a part in a layout of 80", "Boost rtree / Scene", "6.0", 4, kAtLeast, Floor::Worst, "x", layout("Boost")},
      {"a part in its container among 80", "core behind a scan of boxes / Scene", "1.0", 0.8, kAtLeast, Floor::Worst,
       "x", ratios(job("container") && on("80"), method("scan"), scene)},
      {"a robot in a map of 10,000", "core behind a scan of boxes / Scene", "27", 12, kAtLeast, Floor::Worst, "x",
       map("cold")},
      {"a robot in a map of 10,000", "our shapes in FCL's best manager / Scene", "5.4", 3, kAtLeast, Floor::Worst, "x",
       map("via FCL")},
      {"a robot in a map of 10,000", "GEOS STRtree, prepared / Scene", "3.2", 2, kAtLeast, Floor::Worst, "x",
       map("GEOS")},
      {"a robot in a map of 10,000", "Boost rtree / Scene", "3.4", 2, kAtLeast, Floor::Worst, "x", map("Boost")},
      {"rays in that map", "the faster of Box2D and Boost / Scene", "2.9", 1.5, kAtLeast, Floor::Worst, "x",
       ratios(job("rays"), rival, scene)},
      {"one polygon of up to 79,000 islands", "a Scene / one polygon", "0.5", 0.2, kAtLeast, Floor::Worst, "x",
       ratios(job("islands"), method("Scene"), method("one polygon"))},
      {"one polygon of up to 79,000 islands", "power of their number", "0.30", 0.35, kAtMost, Floor::Worst, "",
       growth(job("islands"), method("one polygon"))},
      {"locate among islands", "a query", "0.42", 3, kAtMost, Floor::Worst, "us",
       ratios(job("islands") && named("locate"), method("one polygon"), constant(1e3))},
      {"a cache beside none, collide", "cached / without", "1.04, once 1.37", 1.15, kAtMost, Floor::Worst, "x",
       cache("collide")},
      {"a cache beside none, distance", "cached / without", "1.05", 1.15, kAtMost, Floor::Worst, "x",
       cache("distance")},
      {"a cache beside none, contacts", "cached / without", "1.05", 1.15, kAtMost, Floor::Worst, "x",
       cache("contacts")},
      {"a cache beside none, penetration", "cached / without", "1.02", 1.15, kAtMost, Floor::Worst, "x",
       cache("penetration")},
      {"a cache beside none, locate", "cached / without", "8.6", 1.15, kAtMost, Floor::Worst, "x", cache("locate")},
      {"contact points", "points / crossings", "1.95", 2.5, kAtMost, Floor::Worst, "x", detail("points")},
      {"contact points with local depths", "local depths / crossings", "3.9", 7, kAtMost, Floor::Worst, "x",
       detail("local depths")},
      {"penetration, contours of 64 deep in each other", "f8f33f8's, by way of GEOS's overlay / core", "1", 0.4,
       kAtLeast, Floor::Worst, "x", besidePenetrationBefore(64, kPenetration64)},
      {"penetration, contours of 512 deep in each other", "f8f33f8's, by way of GEOS's overlay / core", "1", 0.4,
       kAtLeast, Floor::Worst, "x", besidePenetrationBefore(512, kPenetration512)},
      {"maps at rest, up to one million 8-gons", "bytes a body, its polygon included", "617", 700, kAtMost,
       Floor::Worst, "bytes", still("bytes", 1)},
      {"maps at rest, up to one million 8-gons", "a body made and added", "0.95", 1.3, kAtMost, Floor::Worst, "us",
       still("made", 1e3)},
      {"distance at a gap of 1e-12", "/ at a gap of 1e-3", "1.1", 2, kAtMost, Floor::Worst, "x", gap("distance")},
      {"a body that tips, slides or rests close to another", "a time of impact, any gap and time_error", "0.060", 1,
       kAtMost, Floor::Worst, "ms", ratios(job("gap") && named("time of impact"), longest, constant(1e6))},
      {"collide in contact, 64 to 1,024 vertices", "power of their number", "", 1.3, kAtMost, Floor::Worst, "",
       growth(study && named("contact"), core)},
      {"distance, 64 to 1,024 vertices", "power of their number", "", 1.3, kAtMost, Floor::Worst, "",
       growth(distances, cold)},
      {"time of impact, 64 to 1,024 vertices", "power of their number", "", 1.3, kAtMost, Floor::Worst, "",
       growth(job("impact"), core)},
      {"contacts of contours, 64 to 512 vertices", "power of their number", "", 1.3, kAtMost, Floor::Worst, "",
       growth(job("detail") && on("contour"), method("local depths"))},
  };
}

/// A row's floor and what this run measured.
struct Judged {
  const Floor* floor;
  std::optional<Figure> figure;  ///< nothing: not measured
  std::size_t cells;

  bool met() const {
    return !figure || (floor->at_least ? figure->value >= floor->floor : figure->value <= floor->floor);
  }
  std::string wanted() const {
    return (floor->at_least ? "at least " : "at most ") + inWords(floor->floor) +
           (floor->of == Floor::Median ? ", median" : "");
  }
  std::string measured() const { return figure ? inWords(figure->value) : "not measured"; }
  const char* verdict() const { return !figure ? "not measured" : met() ? "yes" : "no"; }

 private:
  std::string inWords(double value) const {
    const std::string unit = floor->unit, number = shortNumber(value);
    if (unit.empty()) return "n^" + number;
    return number + (unit != "x" ? ' ' + unit : floor->at_least ? " times as fast" : " times as long");
  }
};

Judged judged(const Floor& floor, const Cells& cells) {
  Figures figures = floor.take(cells);
  if (figures.empty()) return {&floor, {}, 0};
  std::sort(figures.begin(), figures.end(), [](const Figure& p, const Figure& q) { return p.value < q.value; });
  const std::size_t n = figures.size();
  const Figure median = {(figures[(n - 1) / 2].value + figures[n / 2].value) / 2, ""};
  return {&floor, floor.of == Floor::Median ? median : floor.at_least ? figures.front() : figures.back(), n};
}

std::string csvOf(const std::vector<Judged>& rows) {
  std::string csv = "row,compared,statistic,direction,floor,unit,at_f8f33f8,measured,worst_cell,cells,met\n";
  for (const Judged& row : rows) {
    const Floor& floor = *row.floor;
    csv += quotedField(floor.subject) + ',' + quotedField(floor.compared) + ',' +
           (floor.of == Floor::Worst ? "worst" : "median") + ',' + (floor.at_least ? "at least" : "at most") + ',' +
           shortNumber(floor.floor) + ',' + floor.unit + ',' + quotedField(floor.before) + ',' +
           (row.figure ? formatted("%.4g", row.figure->value) + ',' + quotedField(row.figure->cell) : ",") + ',' +
           std::to_string(row.cells) + ',' + row.verdict() + '\n';
  }
  return csv;
}

int run(const std::string& directory) {
  Cells cells;
  for (const char* file : {"results", "scenes", "first", "asked", "box2d_v3"})
    readCells(directory + "/" + file + ".csv", cells);
  const std::vector<Floor> floors = allFloors();
  std::vector<Judged> rows;
  for (const Floor& floor : floors) rows.push_back(judged(floor, cells));
  TextTable lines = {{"row", "compared", "at f8f33f8", "floor", "measured", "cells", "met", "worst cell"}};
  std::string short_of;
  for (const Judged& row : rows) {
    lines.push_back({row.floor->subject, row.floor->compared, row.floor->before, row.wanted(), row.measured(),
                     std::to_string(row.cells), row.verdict(), row.figure ? row.figure->cell : ""});
    if (!row.met())
      short_of += "- " + std::string(row.floor->subject) + ": " + row.floor->compared + ": " + row.measured() + ", " +
                  row.wanted() + " is the floor (" + row.figure->cell + ")\n";
  }
  const std::string text =
      "# Floors\n\n" + markdown(lines) +
      "\n- A / B, times as fast: the time of A divided by that of B. Of A / B, times as long, less is better.\n"
      "- cells: how many figures the worst, or the median, was chosen from.\n\nBelow their floor:\n" +
      (short_of.empty() ? "- none\n" : short_of);
  std::fputs(text.c_str(), stdout);
  writeFile(directory + "/floors.md", text);
  writeFile(directory + "/floors.csv", csvOf(rows));
  return 0;
}

}  // namespace
}  // namespace tricover::bench

int main(int argc, char** argv) {
  using namespace tricover::bench;
  return runProgram(argv[0], "<report directory>", argc == 2, [&] { return run(argv[1]); });
}
