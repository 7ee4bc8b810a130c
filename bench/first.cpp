// SPDX-License-Identifier: BSD-3-Clause
// First answers: polygons made of raw vertices and asked k times, all in, beside what others take for the same.
// Needs no FCL.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "first_methods.h"
#include "measure.h"
#include "poses.h"
#include "random.h"
#include "report.h"
#include "target.h"
#include "tricover/collide.h"
#include "workloads.h"

namespace tricover::bench {
namespace {

constexpr std::size_t kQueries[] = {1, 2, 3, 5, 10, 20, 30, 50, 100};
constexpr std::size_t kMostQueries = 100;
constexpr std::size_t kPairs = 16;
constexpr int kRounds = 7;

/// Pairs of rings, and for each pair the poses that it may be asked at.
struct FirstCell {
  std::string polygons, poses;
  std::size_t vertices;
  bool convex;
  std::vector<Polygon> fixed, moving;
  std::vector<std::vector<Pose>> at;

  /// How often a pair is made and asked, so that a round takes some milliseconds at most.
  std::size_t visits() const { return std::min<std::size_t>(64, 8192 / vertices); }
  FirstAsked visit(std::size_t i, std::size_t queries) const {
    const std::size_t pair = i % kPairs;
    return {fixed[pair].rings()[0], moving[pair].rings()[0], at[pair].data() + i, queries};
  }
};

/// An arrowhead or, convex, a kite, of 100 units.
Polygon quadrilateral(bool convex, std::uint64_t seed) {
  support::Random random(seed);
  const double half = random.real(10, 40), tail = convex ? random.real(55, 90) : random.real(10, 40);
  const double tip = convex ? 0 : 100;
  return Polygon({{{tip, -half}, {tail, 0}, {tip, half}, {convex ? -10 : 0, 0}}});
}

Polygon ringOf(std::size_t vertices, bool convex, std::uint64_t seed) {
  if (vertices == 4) return quadrilateral(convex, seed);
  return workloads::makePolygon(convex ? workloads::Kind::Slim : workloads::Kind::Contour, vertices, seed);
}

FirstCell makeCell(std::size_t vertices, bool convex, const std::string& poses) {
  FirstCell cell{convex ? "convex" : "outline", poses, vertices, convex, {}, {}, {}};
  for (std::size_t pair = 0; pair < kPairs; ++pair) {
    cell.fixed.push_back(ringOf(vertices, convex, 2 * pair + 1));
    cell.moving.push_back(ringOf(vertices, convex, 2 * pair + 2));
    const Polygon &a = cell.fixed.back(), &b = cell.moving.back();
    const std::size_t positions = cell.visits() + kMostQueries;
    cell.at.push_back(poses == "near" ? workloads::nearPoses(a, b, pair, positions)
                                      : workloads::overlapPoses(a, b, pair, positions));
  }
  return cell;
}

struct FirstTime {
  double ns;  ///< a query, all in
  std::size_t hits;
};

/// One row of the table: k queries of each method that fits, in the methods' order.
struct FirstRow {
  const FirstCell* cell;
  std::size_t queries;
  std::vector<const FirstMethod*> methods;
  std::vector<FirstTime> times;
  double dearest_later;  ///< ns of the dearest query of tricover's behind the first one; 0 for k = 1

  double ns(const char* method) const {
    for (std::size_t i = 0; i < methods.size(); ++i)
      if (std::string(methods[i]->name) == method) return times[i].ns;
    return 0;
  }
  double fastestLibrary() const {
    double least = 0;
    for (std::size_t i = 1; i < methods.size(); ++i)
      if (methods[i]->library && (least == 0 || times[i].ns < least)) least = times[i].ns;
    return least;
  }
};

/// ns of each of k queries behind the first: of all visits the dearest, each the least of several rounds.
double dearestLater(const FirstCell& cell, std::size_t queries) {
  using Clock = std::chrono::steady_clock;
  double dearest = 0;
  for (std::size_t i = 0; i < std::min<std::size_t>(cell.visits(), kPairs); ++i) {
    const FirstAsked asked = cell.visit(i, queries);
    std::vector<double> least(queries, 1e18);
    for (int round = 0; round < kRounds; ++round) {
      const Polygon fixed(std::vector<Ring>(1, asked.fixed)), moving(std::vector<Ring>(1, asked.moving));
      for (std::size_t k = 0; k < queries; ++k) {
        const auto start = Clock::now();
        collide(fixed, Pose::Identity(), moving, asked.poses[k]);
        least[k] = std::min(least[k], std::chrono::duration<double, std::nano>(Clock::now() - start).count());
      }
    }
    for (std::size_t k = 1; k < queries; ++k) dearest = std::max(dearest, least[k]);
  }
  return dearest;
}

FirstRow measureRow(const FirstCell& cell, std::size_t queries) {
  FirstRow row{&cell, queries, {}, {}, 0};
  std::vector<std::function<void()>> tasks;
  std::vector<std::size_t> hits(firstMethods().size());
  for (const FirstMethod& method : firstMethods()) {
    if (method.convex_only && (!cell.convex || cell.vertices > 8)) continue;
    tasks.push_back([&cell, &method, queries, &counted = hits[tasks.size()]] {
      counted = 0;
      for (std::size_t i = 0; i < cell.visits(); ++i) counted += method.hits(cell.visit(i, queries));
    });
    row.methods.push_back(&method);
  }
  const std::vector<double> seconds = secondsInTurn(tasks, kRounds, threadSeconds);
  const double asked = static_cast<double>(cell.visits() * queries);
  for (std::size_t i = 0; i < tasks.size(); ++i) row.times.push_back({1e9 * seconds[i] / asked, hits[i]});
  row.dearest_later = dearestLater(cell, queries);
  return row;
}

std::string firstTable(const std::vector<FirstRow>& rows) {
  TextTable lines = {{"polygons", "poses", "k"}};
  for (const FirstMethod& method : firstMethods()) lines[0].push_back(method.name);
  for (const char* column : {"library / tricover", "tricover / plain loop", "dearest later query"})
    lines[0].push_back(column);
  for (const FirstRow& row : rows) {
    lines.push_back(
        {row.cell->polygons + ", " + std::to_string(row.cell->vertices), row.cell->poses, std::to_string(row.queries)});
    for (const FirstMethod& method : firstMethods()) {
      const double ns = row.ns(method.name);
      lines.back().push_back(ns > 0 ? shortNumber(ns) : "");
    }
    lines.back().push_back(formatted("%.2f", row.fastestLibrary() / row.ns("tricover")));
    lines.back().push_back(formatted("%.2f", row.ns("tricover") / row.ns("a plain loop")));
    lines.back().push_back(row.queries > 1 ? shortNumber(row.dearest_later) : "");
  }
  return markdown(lines);
}

std::string firstCsv(const std::vector<FirstRow>& rows) {
  std::string csv = "polygons,vertices,poses,queries,method,ns_per_query,hits\n";
  for (const FirstRow& row : rows) {
    for (std::size_t i = 0; i < row.methods.size(); ++i) {
      csv += row.cell->polygons + ',' + std::to_string(row.cell->vertices) + ',' + row.cell->poses + ',' +
             std::to_string(row.queries) + ',' + row.methods[i]->name + ',' + shortNumber(row.times[i].ns) + ',' +
             std::to_string(row.times[i].hits) + '\n';
    }
  }
  return csv;
}

const char* const kHow =
    R"(- Nanoseconds a query, all in: both polygons made of raw vertices, asked under k poses, and forgotten. CPU time of one
  thread, methods in turn, medians of 7. Others move the vertices and build what they need.
- The dearest later query: of tricover's queries behind the first, wall time, the dearest of 16 pairs, each the least of 7.
)";

int run(const std::string& directory, const std::string& only) {
  std::vector<FirstCell> cells;
  for (const bool convex : {false, true}) {
    for (const std::size_t vertices : {4, 8, 24, 64, 1024}) {
      for (const char* poses : {"near", "deep"}) {
        const std::string name = (convex ? "convex, " : "outline, ") + std::to_string(vertices) + ", " + poses;
        if ((!convex || vertices <= 8) && name.find(only) != std::string::npos)
          cells.push_back(makeCell(vertices, convex, poses));
      }
    }
  }
  std::vector<FirstRow> rows;
  for (const FirstCell& cell : cells)
    for (const std::size_t queries : kQueries) rows.push_back(measureRow(cell, queries));
  const std::string report = "# First answers\n\n" + firstTable(rows) + "\n" + kHow;
  if (directory == "-") {
    std::fputs(report.c_str(), stdout);
  } else {
    writeFile(directory + "/first.md", report);
    writeFile(directory + "/first.csv", firstCsv(rows));
  }
  return 0;
}

}  // namespace
}  // namespace tricover::bench

int main(int argc, char** argv) {
  using namespace tricover::bench;
  return runProgram(argv[0], "<existing report directory, or - for stdout> [part of a cell's name]",
                    argc == 2 || argc == 3, [&] { return run(argv[1], argc == 3 ? argv[2] : ""); });
}
