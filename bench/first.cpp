// SPDX-License-Identifier: BSD-3-Clause
// First answers: polygons made of raw vertices and asked k times, all in, beside what others take for the same.
// The methods are in a file of their own.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "first_methods.h"
#include "measure.h"
#include "poses.h"
#include "random.h"
#include "report.h"
#include "target.h"
#include "tricover/collide.h"
#include "tricover/prepare.h"
#include "workloads.h"

namespace tricover::bench {
namespace {

constexpr std::size_t kQueries[] = {1, 2, 3, 5, 10, 20, 30, 50, 100};
constexpr std::size_t kVertices[] = {4, 8, 24, 64, 1024};
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

/// One row of the table: k queries of each method that fits, in the methods' order, ns a query all in.
struct FirstRow {
  const FirstCell* cell;
  std::size_t queries;
  std::vector<const FirstMethod*> methods;
  std::vector<double> ns;
  std::vector<std::size_t> hits;
  double dearest_later;     ///< ns of the dearest query of tricover's behind the first one; 0 for k = 1
  double dearest_prepared;  ///< see dearestPrepared(); of the most queries alone, otherwise 0

  std::string name() const {
    return cell->polygons + " " + std::to_string(cell->vertices) + ", " + cell->poses +
           ", k = " + std::to_string(queries);
  }
  /// Of the methods of a kind the fastest; 0 where there is none.
  double fastest(std::initializer_list<FirstMethod::Kind> kinds) const {
    double least = 0;
    for (std::size_t i = 0; i < methods.size(); ++i)
      if (std::count(kinds.begin(), kinds.end(), methods[i]->kind) > 0 && (least == 0 || ns[i] < least)) least = ns[i];
    return least;
  }
  double ours() const { return fastest({FirstMethod::Ours}); }
  double library() const { return fastest({FirstMethod::Library, FirstMethod::Convex}); }
};

/// Asks all queries, and keeps the least ns that each has taken.
void timeEach(const Polygon& fixed, const Polygon& moving, const FirstAsked& asked, std::vector<double>& least) {
  using Clock = std::chrono::steady_clock;
  for (std::size_t k = 0; k < least.size(); ++k) {
    const auto start = Clock::now();
    collide(fixed, Pose::Identity(), moving, asked.poses[k]);
    least[k] = std::min(least[k], std::chrono::duration<double, std::nano>(Clock::now() - start).count());
  }
}

/// visit(ns of each query of a new pair, ns of each when it is asked them all once more), for several pairs, each the
/// least of several rounds. `ready` is called with both new polygons.
template <class Ready, class Visit>
void timePairs(const FirstCell& cell, std::size_t queries, Ready ready, Visit visit) {
  for (std::size_t i = 0; i < std::min<std::size_t>(cell.visits(), kPairs); ++i) {
    const FirstAsked asked = cell.visit(i, queries);
    std::vector<double> first(queries, 1e18), later = first;
    for (int round = 0; round < kRounds; ++round) {
      const Polygon fixed(asked.fixed.data(), asked.fixed.size()), moving(asked.moving.data(), asked.moving.size());
      ready(fixed), ready(moving);
      timeEach(fixed, moving, asked, first);
      timeEach(fixed, moving, asked, later);
    }
    visit(first, later);
  }
}

/// ns of the dearest of k queries behind the first.
double dearestLater(const FirstCell& cell, std::size_t queries) {
  double dearest = 0;
  timePairs(
      cell, queries, [](const Polygon&) {},
      [&](const std::vector<double>& first, const std::vector<double>&) {
        for (std::size_t k = 1; k < queries; ++k) dearest = std::max(dearest, first[k]);
      });
  return dearest;
}

/// Of prepared polygons: of all queries the dearest, in what the same one takes later.
double dearestPrepared(const FirstCell& cell, std::size_t queries) {
  double dearest = 0;
  timePairs(cell, queries, prepare, [&](const std::vector<double>& first, const std::vector<double>& later) {
    for (std::size_t k = 0; k < queries; ++k) dearest = std::max(dearest, first[k] / later[k]);
  });
  return dearest;
}

/// What polygons answer that have been asked often.
std::size_t hitsKnown(const FirstCell& cell, std::size_t queries) {
  std::size_t hits = 0;
  for (std::size_t i = 0; i < cell.visits(); ++i)
    for (std::size_t k = 0; k < queries; ++k)
      hits += collide(cell.fixed[i % kPairs], Pose::Identity(), cell.moving[i % kPairs], cell.at[i % kPairs][i + k])
                  ? 1
                  : 0;
  return hits;
}

FirstRow measureRow(const FirstCell& cell, std::size_t queries) {
  FirstRow row{&cell, queries, {}, {}, {}, 0, 0};
  for (const FirstMethod& method : firstMethods())
    if (method.takes(cell.convex, cell.vertices)) row.methods.push_back(&method);
  row.hits.resize(row.methods.size());
  std::vector<std::function<void()>> tasks;
  for (std::size_t m = 0; m < row.methods.size(); ++m) {
    tasks.push_back([&, m] {
      row.hits[m] = 0;
      for (std::size_t i = 0; i < cell.visits(); ++i) row.hits[m] += row.methods[m]->hits(cell.visit(i, queries));
    });
  }
  for (const double seconds : secondsInTurn(tasks, kRounds, threadSeconds))
    row.ns.push_back(1e9 * seconds / static_cast<double>(cell.visits() * queries));
  row.dearest_later = dearestLater(cell, queries);
  if (queries == kMostQueries) row.dearest_prepared = dearestPrepared(cell, queries);
  return row;
}

std::string firstTable(const std::vector<FirstRow>& rows) {
  TextTable lines = {{"polygons", "poses", "k"}};
  for (const FirstMethod& method : firstMethods()) lines[0].push_back(method.name);
  lines[0].insert(lines[0].end(), {"library / tricover", "dearest later query", "dearest prepared / later"});
  for (const FirstRow& row : rows) {
    if (row.queries != 1 && row.queries != 3 && row.queries != 10 && row.queries != 100) continue;
    lines.push_back(
        {row.cell->polygons + ", " + std::to_string(row.cell->vertices), row.cell->poses, std::to_string(row.queries)});
    std::size_t next = 0;
    for (const FirstMethod& method : firstMethods()) {
      const bool asked = next < row.methods.size() && row.methods[next] == &method;
      lines.back().push_back(asked ? shortNumber(row.ns[next++]) : "");
    }
    lines.back().push_back(formatted("%.2f", row.library() / row.ours()));
    lines.back().push_back(row.queries > 1 ? shortNumber(row.dearest_later) : "");
    lines.back().push_back(row.dearest_prepared > 0 ? formatted("%.2f", row.dearest_prepared) : "");
  }
  return markdown(lines);
}

std::string firstCsv(const std::vector<FirstRow>& rows) {
  std::string csv = "polygons,vertices,poses,queries,method,ns_per_query,hits\n";
  for (const FirstRow& row : rows) {
    for (std::size_t i = 0; i < row.methods.size(); ++i) {
      csv += row.cell->polygons + ',' + std::to_string(row.cell->vertices) + ',' + row.cell->poses + ',' +
             std::to_string(row.queries) + ',' + row.methods[i]->name + ',' + shortNumber(row.ns[i]) + ',' +
             std::to_string(row.hits[i]) + '\n';
    }
  }
  return csv;
}

/// What is wanted of the rows that `holds` names: so much of above / below.
template <class Holds, class Above, class Below>
void judgeRows(const std::vector<FirstRow>& rows, const std::string& subject, const std::string& compared,
               const Wanted& wanted, Holds holds, Above above, Below below, std::vector<Target>& to) {
  std::vector<Figure> figures;
  for (const FirstRow& row : rows)
    if (holds(row) && above(row) > 0) figures.push_back({above(row) / below(row), row.name()});
  if (!figures.empty()) to.push_back(judged(subject, compared, std::move(figures), wanted));
}

std::vector<Target> judge(const std::vector<FirstRow>& rows) {
  std::vector<Target> targets;
  const auto ours = [](const FirstRow& row) { return row.ours(); };
  const auto library = [](const FirstRow& row) { return row.library(); };
  const bool through_fcl = firstMethods()[0].name != std::string("tricover");
  const std::string what = through_fcl ? "first answers through FCL" : "first answers";
  const auto compare = [&](const char* sizes, std::size_t least, std::size_t most, double times) {
    judgeRows(
        rows, what + ", " + sizes, "best library / ours", {true, through_fcl ? 2 : times},
        [&](const FirstRow& row) { return row.cell->vertices >= least && row.cell->vertices <= most; }, library, ours,
        targets);
  };
  compare("4 vertices", 4, 4, 1);
  compare("8 vertices", 8, 8, 1.5);
  compare("24 vertices and more", 24, 1024, 3);
  judgeRows(
      rows, what + ", the very first, 24 vertices and more", "core / a plain loop", {false, 4},
      [](const FirstRow& row) {
        return row.queries == 1 && row.cell->vertices >= 24 && row.fastest({FirstMethod::Loop}) > 0;
      },
      ours, [](const FirstRow& row) { return row.fastest({FirstMethod::Loop}); }, targets);
  judgeRows(
      rows, what + ", convex", "Box2D / core", {true, 1}, [](const FirstRow&) { return true; },
      [](const FirstRow& row) { return row.fastest({FirstMethod::Box2d}); }, ours, targets);
  if (!through_fcl)
    judgeRows(
        rows, "queries after prepare(), the dearest", "at first / later", {false, 3},
        [](const FirstRow& row) { return row.dearest_prepared > 0; },
        [](const FirstRow& row) { return row.dearest_prepared; }, [](const FirstRow&) { return 1.0; }, targets);
  return targets;
}

const char* const kHow =
    R"(- Nanoseconds a query, all in: both polygons made of raw vertices, asked under k poses, and forgotten. CPU time of one
  thread, methods in turn, medians of 7. Others move the vertices and build what they need.
- The dearest later query: of tricover's queries behind the first, wall time, the dearest of 16 pairs, each the least of 7.
- The dearest prepared / later: of 100 queries right after `prepare()`, in what the same one takes when all are asked once more.
)";

int run(const std::string& directory, const std::string& only) {
  std::vector<FirstCell> cells;
  for (const bool convex : {false, true}) {
    for (const std::size_t vertices : kVertices) {
      for (const char* poses : {"near", "deep"}) {
        const std::string name = (convex ? "convex, " : "outline, ") + std::to_string(vertices) + ", " + poses;
        if ((!convex || vertices <= 8) && name.find(only) != std::string::npos)
          cells.push_back(makeCell(vertices, convex, poses));
      }
    }
  }
  std::vector<FirstRow> rows;
  bool agree = true;
  for (const FirstCell& cell : cells) {
    for (const std::size_t queries : kQueries) {
      rows.push_back(measureRow(cell, queries));
      agree = agree && rows.back().hits[0] == hitsKnown(cell, queries);
    }
  }
  const std::vector<Target> targets = judge(rows);
  const std::string report = "# First answers\n\n" + targetsTable(targets) + "\n" + firstTable(rows) + "\n" + kHow;
  if (directory == "-") {
    std::fputs(report.c_str(), stdout);
  } else {
    const std::string path = directory + "/" + kFirstReport;
    writeFile(path + ".md", report);
    writeFile(path + ".csv", firstCsv(rows));
    writeFile(path + "_targets.csv", targetsCsv(targets));
  }
  if (!agree) std::fprintf(stderr, "first answers differ from later ones\n");
  return agree ? 0 : 1;
}

}  // namespace
}  // namespace tricover::bench

int main(int argc, char** argv) {
  using namespace tricover::bench;
  return runProgram(argv[0], "<existing report directory, or - for stdout> [part of a cell's name]",
                    argc == 2 || argc == 3, [&] { return run(argv[1], argc == 3 ? argv[2] : ""); });
}
