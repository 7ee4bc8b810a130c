// SPDX-License-Identifier: BSD-3-Clause
#include "extremes.h"

#include <cmath>
#include <cstdio>
#include <vector>

#include "child.h"
#include "extreme_scenes.h"
#include "report.h"
#include "tradeoff_methods.h"

namespace tricover::bench {
namespace {

/// Of all placements, those that a method answered wrongly, and those that it gave no answer to.
struct Faults {
  std::size_t asked = 0, wrong = 0, failed = 0;

  std::string text() const {
    if (asked == 0) return "";
    if (failed == asked) return "fails";
    return std::to_string(wrong) + (failed > 0 ? ", " + std::to_string(failed) + " fail" : "");
  }
  /// Of not being right.
  double share() const { return static_cast<double>(wrong + failed) / static_cast<double>(asked); }
};

/// Asks in a child process, which may crash or hang; what it didn't come to has failed.
Faults ask(const Method& method, const Scene& scene) {
  const std::vector<double> answers = askInChild(scene.placements.size(), [&] {
    return [&](std::size_t i) {
      Scene one = scene;
      one.placements = {scene.placements[i]};
      Hits hits;
      method.make(one).walk(Sampling{}, hits);
      return hits.empty() ? 0.0 : 1.0;
    };
  });
  Faults faults{answers.size(), 0, 0};
  for (std::size_t i = 0; i < answers.size(); ++i) {
    faults.failed += std::isnan(answers[i]);
    faults.wrong += answers[i] == (scene.placements[i].collides ? 0 : 1);
  }
  return faults;
}

/// The stages that only ever say "maybe" are wrong by design: not shown.
std::vector<Method> shownMethods() {
  std::vector<Method> methods;
  for (const Method& method : tradeoffMethods()) {
    const bool stage = method.family == "bounding discs" || method.family == "influence areas";
    if (!stage && (method.setting.empty() || method.setting == "1e-6" || method.setting == "1e-12")) {
      methods.push_back(method);
    }
  }
  return methods;
}

/// faults[method][exponent].
using Grid = std::vector<std::vector<Faults>>;

Grid askAll(const Sweep& sweep, const std::vector<Method>& methods, std::size_t contacts) {
  Grid grid(methods.size(), std::vector<Faults>(sweep.exponents.size()));
  for (std::size_t e = 0; e < sweep.exponents.size(); ++e) {
    for (const workloads::Kind kind : extremeKinds()) {
      const Scene plain = plainScene(kind), scene = extremeScene(sweep, sweep.exponents[e], kind, contacts);
      for (std::size_t m = 0; m < methods.size(); ++m) {
        if (!methods[m].takes(plain)) continue;
        const Faults faults = ask(methods[m], scene);
        grid[m][e].asked += faults.asked;
        grid[m][e].wrong += faults.wrong;
        grid[m][e].failed += faults.failed;
      }
    }
  }
  return grid;
}

const char* const kHow =
    R"(- Polygons of 8 vertices (round and slim convex, starred, with hole), 100 units long before they are moved or
  scaled. Poses: around first contact as for the trade-off, at 1 ulp, 1e-13, 1e-10, 1e-7, 1e-4 and 0.1 of the size,
  either way. The truth is exact arithmetic's, on the doubles that remain after the move.
- vertices moved: both polygons' own coordinates are large, and so are the pose's. poses moved: the coordinates stay,
  both poses have a far translation; rivals that know one pose only (GEOS, Boost) get the fixed polygon's coordinates
  there.
- A number is the count of wrong answers out of those in the second column; methods for convex polygons are asked about
  those only. "fail": an exception, a crash, or no answer within a second, after which the rest counts as failed, too.
  BVH's triangles are GEOS's, and fail where GEOS fails. Box2D's unit is a metre, and not all scales are meant for it.
- plain float, plain double: the relative pose is computed in doubles, the signs after that.
- tolerance: false alarms within it are what was asked for, and counted all the same.
)";

}  // namespace

bool runExtremes(const std::string& directory, bool full) {
  const std::vector<Method> methods = shownMethods();
  std::string text = "# Stability at the extremes: wrong answers\n\n",
              csv = "sweep,exponent,method,queries,wrong,failed\n", data;
  bool exact_is_right = true;
  for (const Sweep& sweep : sweeps()) {
    const Grid grid = askAll(sweep, methods, full ? 16 : 4);
    TextTable lines = {{"method", "of"}};
    for (const int exponent : sweep.exponents) lines[0].push_back(powerOfTen(exponent));
    data += "# " + sweep.name + "\n";
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const std::string name = methods[m].name();
      lines.push_back({name, std::to_string(grid[m][0].asked)});
      for (std::size_t e = 0; e < sweep.exponents.size(); ++e) {
        const Faults& faults = grid[m][e];
        lines.back().push_back(faults.text());
        csv += '"' + sweep.name + "\"," + powerOfTen(sweep.exponents[e]) + ",\"" + name + "\"," +
               std::to_string(faults.asked) + ',' + std::to_string(faults.wrong) + ',' + std::to_string(faults.failed) +
               '\n';
        char line[160];
        std::snprintf(line, sizeof line, "%zu %zu \"%s\" \"%s\" %.4f\n", e, m, name.c_str(),
                      powerOfTen(sweep.exponents[e]).c_str(), faults.share());
        data += line;
        if (name == kExact && faults.share() > 0) exact_is_right = false;
      }
    }
    data += "\n\n";
    text += "## " + sweep.name + "\n\n" + markdown(lines) + "\n";
  }
  writeFile(directory + "/extremes.md", text + "# How it was measured\n\n" + kHow);
  writeFile(directory + "/extremes.csv", csv);
  writeFile(directory + "/extremes.dat", data);
  if (!exact_is_right) std::fputs("error: the exact method was wrong or failed at an extreme\n", stderr);
  return exact_is_right;
}

}  // namespace tricover::bench
