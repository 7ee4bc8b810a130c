// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

#include "report.h"
#include "value_problems.h"

namespace tricover::bench {
namespace {

using workloads::Kind;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Row {
  std::string query;
  bool of_time;
  std::string group, family, method;
  std::size_t asked;
  double ns, worst = 0, worst_relative = 0, worst_of_size = 0;
  std::size_t wrong = 0;
  bool keeps_promise = true;
};

std::vector<Row> scored(const ValueProblem& problem, Settings settings) {
  const std::size_t queries = problem.truth.size();
  std::vector<ValueContender> contenders = {
      contender<Values>("truth", Role::Floor, false, queries, [&problem](std::size_t i) { return problem.truth[i]; })};
  for (const ValueMethod& method : problem.methods) {
    contenders.push_back(method.make());
    contenders.back().name = method.name();
  }
  const KnownScene& scene = *problem.scene;
  const Workload workload{"values", scene.group, scene.name, scene.fixed.vertexCount(), scene.moving.vertexCount(),
                          queries};
  settings.agreement = {0, {kInfinity, kInfinity}, {kInfinity, kInfinity}};
  const Result result = measure(workload, contenders, settings);
  std::vector<Row> rows;
  for (std::size_t m = 0; m < problem.methods.size(); ++m) {
    const ValueMethod& method = problem.methods[m];
    Row row{problem.query.name,      problem.query.error == ValueQuery::Error::OfTime,
            problem.group,           method.family,
            method.name(),           queries,
            result.timings[m + 1].ns};
    Values values;
    contenders[m + 1].walk(Sampling{}, values);
    for (std::size_t i = 0; i < queries; ++i) {
      const ValueError error = errorOf(problem, method, i, values[i]);
      row.worst = std::max(row.worst, std::min(error.counted, 1.0));
      row.worst_relative = std::max(row.worst_relative, error.relative);
      row.worst_of_size = std::max(row.worst_of_size, error.of_size);
      row.wrong += error.wrong;
      row.keeps_promise = row.keeps_promise && error.keeps_promise;
    }
    rows.push_back(row);
  }
  return rows;
}

const char* const kHow =
    R"(- distance: truths are exact rational arithmetic's. Wrong: 0 where the regions are apart by more than 1e-13 of the
  size. FCL's tolerances are the solvers' distance_tolerance (libccd) and gjk_tolerance (indep). Errors above 1 are
  shown as 1.
- time of impact: the error is in time, which runs from 0 to 1. The truth is the finest setting's, confirmed by exact
  collisions: none at 64 times before it and one within 1e-6 after; grazes, where that fails, are left out. Wrong: later
  than the truth by more than 1e-9, or a contact missed. FCL's advancement stops at 1e-5 whatever it is asked for.
- contacts: the deepest one's depth, of convex pairs that are 1e-13 to 1e-1 of the size behind first contact, against
  exact arithmetic's. Wrong: no contact, or a depth too small by more than 1e-9 of the size.
- penetration: of convex pairs the truth is exact arithmetic's least gap between supports, of others the depth that was
  proven least. Wrong: less than that by more than 1e-9 of the size, so that moving by it doesn't part the polygons.
  FCL's prisms are so high that they part sideways. EPA's depths have the wrong sign, which isn't counted.
)";

std::string tables(const std::vector<Row>& rows) {
  std::string text, query, group;
  TextTable lines;
  const auto flush = [&] {
    if (!lines.empty()) text += markdown(lines) + "\n";
    lines.clear();
  };
  for (const Row& row : rows) {
    if (row.query != query || row.group != group) {
      flush();
      if (row.query != query) text += "# " + row.query + "\n\n";
      text += "## " + row.group + " (" + std::to_string(row.asked) + " queries)\n\n";
      query = row.query;
      group = row.group;
      lines = {{"method", "ns per query", row.of_time ? "worst error in time" : "worst error / size",
                "worst relative error", "wrong"}};
    }
    const auto error = [](double value) { return value == 0 ? std::string("0") : formatted("%.0e", value); };
    lines.push_back({row.method, formatted("%.0f", row.ns), error(row.worst_of_size), error(row.worst_relative),
                     std::to_string(row.wrong)});
  }
  flush();
  return text;
}

std::string csvOf(const std::vector<Row>& rows) {
  std::ostringstream out;
  out << "query,group,method,queries,ns_per_query,worst_error,worst_relative_error,wrong\n";
  for (const Row& row : rows)
    out << row.query << ",\"" << row.group << "\",\"" << row.method << "\"," << row.asked << ','
        << formatted("%.2f", row.ns) << ',' << formatted("%.3e", row.worst_of_size) << ','
        << formatted("%.3e", row.worst_relative) << ',' << row.wrong << '\n';
  return out.str();
}

}  // namespace

bool runValueTradeoff(const std::string& directory, bool full) {
  std::vector<KnownScene> scenes;
  for (const auto& [kind, vertices] : std::vector<std::pair<Kind, std::size_t>>{
           {Kind::Convex, 8}, {Kind::Slim, 8}, {Kind::Convex, 32}, {Kind::Contour, 32}, {Kind::Irregular, 32}}) {
    scenes.push_back(makeScene(kind, vertices));
    scenes.back().poses = placementsAroundContact(scenes.back(), full ? 16 : 6, 1, 4);
  }
  const Settings settings = full ? Settings{5, 0.02} : Settings{3, 0.002};
  std::vector<Row> rows;
  bool kept = true;
  for (const ValueProblem& problem : valueProblems(scenes, full))
    for (Row& row : scored(problem, settings)) {
      if (!row.keeps_promise)
        std::fprintf(stderr, "error: %s is off by more than it allows: %s\n", row.method.c_str(), row.group.c_str());
      kept = kept && row.keeps_promise;
      rows.push_back(std::move(row));
    }
  writeFile(directory + "/values.md", tables(rows) + "\n# How it was measured\n\n" + kHow);
  writeFile(directory + "/values.csv", csvOf(rows));
  Blocks blocks;  // time and worst error
  for (const Row& row : rows)
    blocks[row.query + " | " + row.group + " | " + row.family] +=
        formatted("%.2f", row.ns) + " " + formatted("%.3e", row.worst) + "\n";
  writeBlocks(directory + "/values.dat", blocks);
  return kept;
}

}  // namespace tricover::bench
