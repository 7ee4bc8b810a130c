// SPDX-License-Identifier: BSD-3-Clause
// The floors' table: reads the CSV files that the other programs left in the report directory, takes each row's figure
// from them, and puts the figure beside its floor. Writes floors.csv and floors.md there.
#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "figures.h"
#include "report.h"

namespace tricover::bench {
namespace {

/// One row of the table. A floor is the least value that is accepted, or the largest where `at_least` is false.
struct Floor {
  const char* subject;
  const char* compared;  ///< how the figure is taken
  const char* before;    ///< what 0.3.0 had at f8f33f8
  double floor;
  Take take;
  bool at_least = true;
  enum { Worst, Median } of = Worst;
  const char* unit = "x";
};

Floor median(Floor floor) {
  floor.of = Floor::Median;
  return floor;
}
Floor atMost(Floor floor, const char* unit = "x") {
  floor.at_least = false;
  floor.unit = unit;
  return floor;
}

/// Section 6 of the design, in its order.
std::vector<Floor> allFloors() {
  const Ns rival = fastest(Role::Rival), box2d = fastest(Role::Box2d), cold = method("cold"), scene = method("scene"),
           via = method("via FCL"), ours = method("tricover"), v3 = method("Box2D v3");
  const Holds study = job("study"), distances = job("distance") && !named("overlap"), impact = job("impact"),
              first = job("first"), layout = job("layout"), map = job("map"), islands = job("islands"),
              still = job("still map"), detail = job("detail"), deep = detail && on("contour") && named("deep");
  const Take best = ratios(study, rival, core), distance = ratios(distances, rival, cold),
             warm = ratios(distances, box2d, core);
  const char *const rival_core = "the best of FCL, GEOS, Boost / core", *const part = "a part in a layout of 80",
                    *const robot = "a robot in a map of 10,000", *const power = "power of their number",
                    *const scan = "core behind a scan of boxes / Scene", *const without = "cached / without",
                    *const last = "Box2D from its last simplex / core", *const solver = "FCL's best solver / via FCL",
                    *const library = "best library / core", *const own = "FCL's own pair / via FCL, the slower order",
                    *const cells = "a robot in a map of cells, anywhere and near walls",
                    *const drive = "a robot that drives 5 m in a map of cells",
                    *const cell_loop = "an exact loop over its cells / core",
                    *const maps = "maps at rest, up to one million 8-gons",
                    *const overlay = "f8f33f8's, by way of GEOS's overlay / core";
  const auto cache = [&](const char* query) {
    return ratios(job("cache") && named(query), method("cached"), method("none"));
  };
  const auto made = [&](std::size_t low, std::size_t high) { return ratios(first && sized(low, high), rival, ours); };
  const auto beside_v3 = [&](const char* query) { return ratios(job("Box2D v3") && named(query), v3, ours); };
  const auto round = [&](const char* query) { return ratios(job("round") && named(query), rival, slowerOrder); };
  const auto beside = [&](const Holds& holds, const char* name) { return ratios(holds, startsWith(name), scene); };
  const auto details = [&](const char* name) { return ratios(detail, method(name), method("crossings")); };
  // Penetration of deep contours beside f8f33f8's: that commit took `reference` times as long as GEOS's overlay of the
  // same regions (the median of three runs: 0.493 to 0.505, 3.28 to 3.38), which is measured again in every run, so
  // that the figure hardly depends on the machine.
  const auto before = [&](std::size_t vertices, double reference) {
    return ratios(deep && sized(vertices, vertices), scaled(reference, method("GEOS overlay")), method("penetration"));
  };
  return {
      {"collide, all cells", rival_core, "1.6", 1.2, best},
      median({"collide, all cells", rival_core, "13.3", 8, best}),
      {"collide, convex and slim 8", "Box2D 2.4 / core", "2.0", 1.3, ratios(study, box2d, core)},
      {"fcl::collide where FCL's first box or support tells most queries", solver, "0.54", 0.5,
       ratios(study && kMostlyAtOnce, kFclSolver, via)},
      {"fcl::collide elsewhere", solver, "1.5", 1.3, ratios(study && !kMostlyAtOnce, kFclSolver, via)},
      {"made and asked 1 to 100 times, 4 vertices", library, "2.3", 1.2, made(4, 4)},
      {"made and asked, 8 vertices", library, "2.5", 1.5, made(8, 8)},
      {"made and asked, 24 to 1,024 vertices", library, "3.5", 2, made(24, 1024)},
      {"soups, needles, overlapping rings", "FCL BVH / core", "2.6", 1.5, ratios(job("soups"), rival, core)},
      {"distance without a cache", rival_core, "1.5", 1, distance},
      median({"distance without a cache", rival_core, "8.5", 5, distance}),
      {"distance, convex and slim 8", last, "0.60", 0.5, warm},
      median({"distance, convex and slim 8", last, "0.88", 0.7, warm}),
      {"time of impact", "FCL's advancement / core", "11.6", 5, ratios(impact, rival, core)},
      {"time of impact, convex and slim 8", "Box2D 2.4, its cast where nothing rotates / core", "3.0", 1,
       ratios(impact, box2d, core)},
      {"beside Box2D v3: slides", "b2ShapeCast / core", "1.1", 0.6, beside_v3("slides, b2ShapeCast")},
      {"beside Box2D v3: rotates", "b2TimeOfImpact / core", "0.66", 0.5, beside_v3("rotates")},
      {"beside Box2D v3: distance", "b2ShapeDistance / core", "0.63", 0.5, beside_v3("distance")},
      {"beside Box2D v3: nearest of 10,000", "a descent of its tree / Scene", "1.1", 0.9, beside_v3("nearest")},
      {"beside Box2D v3: contacts, deep ones too", "b2CollidePolygons / core", "", 0.3, beside_v3("contacts")},
      {"contact of resting and sliding 8-gons", "Box2D's manifold / core", "0.79", 0.5,
       ratios(job("contacts"), box2d, cold)},
      {"polygon and round shape through FCL, collide", own, "0.88", 0.7, round("collide")},
      {"polygon and round shape through FCL, distance", own, "0.48", 0.4, round("distance")},
      {"2,000 moving outlines, whole frames", "BVH meshes in FCL's best manager / Scene", "3.1", 2,
       ratios(job("frames") && on("contour"), method("FCL BVH"), scene)},
      {"2,000 moving 8-gons, whole frames", "Box2D at its best scale / Scene", "2.8", 1.8,
       ratios(job("frames") && on("convex"), box2d, scene)},
      {part, scan, "1.1", 0.85, beside(layout, "cold")},
      {part, "GEOS STRtree, prepared / Scene", "4.2", 3, beside(layout, "GEOS")},
      {part, "Boost rtree / Scene", "6.0", 4, beside(layout, "Boost")},
      {"a part in its container among 80", scan, "1.0", 0.8, beside(job("container") && on("80"), "scan")},
      {"a part in its container among 20 to 50 small ones", scan, "", 0.8,
       beside(job("container") && (on("20 ") || on("50 ")), "scan")},
      {robot, scan, "27", 12, beside(map, "cold")},
      {robot, "our shapes in FCL's best manager / Scene", "5.4", 3, beside(map, "via FCL")},
      {robot, "GEOS STRtree, prepared / Scene", "3.2", 2, beside(map, "GEOS")},
      {robot, "Boost rtree / Scene", "3.4", 2, beside(map, "Boost")},
      {cells, cell_loop, "0.11", 0.8, ratios(job("robot"), method("cells"), method("core"))},
      median({cells, cell_loop, "0.33", 2, ratios(job("robot"), method("cells"), method("core"))}),
      {cells, "an exact loop over its cells / Scene", "0.11", 0.8, ratios(job("robot"), method("cells"), scene)},
      // Sampling took 66 to 131 us before the field, of which 1/15 was wanted; with the field it takes an eighth.
      atMost(
          {drive, "a time of impact", "3.9 to 5.8", 8.7, ratios(job("drive"), method("time of impact"), constant(1e3))},
          "us"),
      {drive, "collide every 2 cm / time of impact", "", 1,
       ratios(job("drive"), method("collide every 2 cm"), method("time of impact"))},
      {"a car in an area of 8 to 1,024 vertices", "GEOS prepared / core", "", 2,
       ratios(job("covers") && sized(8, 1024), rival, ours)},
      {"a car in the union of lanes", "GEOS's prepared union / Scene", "", 2,
       ratios(job("covers") && sized(0, 0), rival, ours)},
      {"rays in that map", "the faster of Box2D and Boost / Scene", "2.9", 1.5, ratios(job("rays"), rival, scene)},
      {"one polygon of up to 79,000 islands", "a Scene / one polygon", "0.5", 0.2,
       ratios(islands, method("Scene"), method("one polygon"))},
      atMost({"one polygon of up to 79,000 islands", power, "0.30", 0.35, growth(islands, method("one polygon"))}, ""),
      atMost({"locate among islands", "a query", "0.42", 3,
              ratios(islands && named("locate"), method("one polygon"), constant(1e3))},
             "us"),
      atMost({"a cache beside none, collide", without, "1.04, once 1.37", 1.15, cache("collide")}),
      atMost({"a cache beside none, distance", without, "1.05", 1.15, cache("distance")}),
      atMost({"a cache beside none, contacts", without, "1.05", 1.15, cache("contacts")}),
      atMost({"a cache beside none, penetration", without, "1.02", 1.15, cache("penetration")}),
      atMost({"contact points", "points / crossings", "1.95", 2.5, details("points")}),
      atMost({"contact points with local depths", "local depths / crossings", "3.9", 7, details("local depths")}),
      atMost({"how deep a point is", "depth / crossings", "", 4, details("depth")}),
      atMost({"a smaller overlap is allowed", "collide / crossings", "", 4, details("a smaller overlap allowed")}),
      atMost({"a larger overlap is allowed", "collide / crossings", "", 4, details("a larger overlap allowed")}),
      {"Hausdorff distance of contours of 64 and 1,024", "GEOS's discrete one, densified by 0.01 / core", "", 5,
       ratios(job("excess"), rival, ours)},
      {"penetration, contours of 64 deep in each other", overlay, "1", 0.4, before(64, 0.50)},
      {"penetration, contours of 512 deep in each other", overlay, "1", 0.4, before(512, 3.35)},
      atMost(
          {maps, "bytes a body, its polygon included", "617", 700, ratios(still && named("bytes"), scene, constant(1))},
          "bytes"),
      atMost({maps, "a body made and added", "0.95", 1.3, ratios(still && named("made"), scene, constant(1e3))}, "us"),
      atMost({"distance at a gap of 1e-12", "/ at a gap of 1e-3", "1.1", 2,
              ratios(job("gap") && named("distance"), method("gap 1e-12"), method("gap 0.001"))}),
      atMost({"a body that tips, slides or rests close to another", "a time of impact, any gap and time_error", "0.060",
              1, ratios(job("gap") && named("time of impact"), longest, constant(1e6))},
             "ms"),
      atMost({"a body that starts in contact, or stays in contact", "conflicts and the next impact, any time_error", "",
              1, ratios(job("lasting"), longest, constant(1e6))},
             "ms"),
      atMost({"outlines simplified outwards", "a vertex, tolerances of one and two cells", "", 50,
              ratios(job("simplify"), longest, constant(1e3))},
             "us"),
      atMost({"collide in contact, 64 to 1,024 vertices", power, "", 1.3, growth(study && named("contact"), core)}, ""),
      atMost({"distance, 64 to 1,024 vertices", power, "", 1.3, growth(distances, cold)}, ""),
      atMost({"time of impact, 64 to 1,024 vertices", power, "", 1.3, growth(impact, core)}, ""),
      atMost({"contacts of contours, 64 to 512 vertices", power, "", 1.3,
              growth(detail && on("contour"), method("local depths"))},
             ""),
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

}  // namespace

bool run(const std::string& directory, bool) {
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
  return true;
}

}  // namespace tricover::bench
