// SPDX-License-Identifier: BSD-3-Clause
#include "extremes.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "report.h"
#include "tradeoff_methods.h"

namespace tricover::bench {
namespace {

using workloads::Kind;

/// One way to the extreme: scene(kind, exponent) gives the polygons.
struct Sweep {
  std::string name;
  std::vector<int> exponents;
  std::function<Scene(Kind kind, int exponent)> scene;
};

Polygon mapped(const Polygon& polygon, const std::function<Vec2(const Vec2&)>& map) {
  std::vector<Ring> rings = polygon.rings();
  for (Ring& ring : rings) std::transform(ring.begin(), ring.end(), ring.begin(), map);
  return Polygon(std::move(rings), polygon.fillRule());
}

Polygon shifted(const Polygon& polygon, double by) {
  return mapped(polygon, [=](const Vec2& v) { return Vec2(v.x() + by, v.y() + by); });
}

Polygon stretched(const Polygon& polygon, double x, double y) {
  return mapped(polygon, [=](const Vec2& v) { return Vec2(v.x() * x, v.y() * y); });
}

std::vector<Sweep> sweeps() {
  const auto polygon = [](Kind kind, std::uint64_t seed) { return workloads::makePolygon(kind, 8, seed); };
  const auto power = [](int exponent) { return std::pow(10, exponent); };
  const auto scene = [](Polygon fixed, Polygon moving) {
    return makeScene("", "", std::move(fixed), std::move(moving));
  };
  const std::vector<int> away = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  const std::vector<int> scales = {-300, -200, -100, -50, -20, -10, -5, 0, 5, 10, 20, 50, 100, 200, 300};
  const std::vector<int> slim = {-1, -2, -3, -4, -5, -6, -7, -8, -9, -10, -11, -12, -13, -14, -15};
  return {
      {"both polygons' vertices moved by", away,
       [=](Kind kind, int exponent) {
         return scene(shifted(polygon(kind, 1), power(exponent)), shifted(polygon(kind, 2), power(exponent)));
       }},
      {"both poses moved by", away,
       [=](Kind kind, int exponent) {
         Scene result = scene(polygon(kind, 1), polygon(kind, 2));
         result.fixed_pose.translation() = Vec2::Constant(power(exponent));
         return result;
       }},
      {"scaled by", scales,
       [=](Kind kind, int exponent) {
         const double factor = power(exponent);
         return scene(stretched(polygon(kind, 1), factor, factor), stretched(polygon(kind, 2), factor, factor));
       }},
      {"slivers, squeezed to", slim,
       [=](Kind kind, int exponent) {
         return scene(stretched(polygon(kind, 1), 1, power(exponent)), stretched(polygon(kind, 2), 1, power(exponent)));
       }},
  };
}

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

constexpr char kFree = 0, kHit = 1, kFailed = 2;

/// The child's part: one answer a placement, each written when it is there.
[[noreturn]] void answerInto(int pipe_end, const Method& method, Scene scene) {
  constexpr unsigned kSeconds = 5;
  alarm(kSeconds);
  // What rivals print in their trouble is no part of the table.
  if (!std::freopen("/dev/null", "w", stderr) || !std::freopen("/dev/null", "w", stdout)) _exit(1);
  const std::vector<Placement> placements = std::move(scene.placements);
  for (const Placement& placement : placements) {
    scene.placements = {placement};
    char answer = kFailed;
    try {
      Hits hits;
      method.make(scene).walk(Sampling{}, hits);
      answer = hits.empty() ? kFree : kHit;
    } catch (const std::exception&) {
    }
    if (write(pipe_end, &answer, 1) != 1) _exit(1);
  }
  _exit(0);
}

/// Asks in a child process, which may crash or hang; what it didn't come to has failed.
Faults ask(const Method& method, const Scene& scene) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("extremes: no pipe");
  std::fflush(nullptr);  // or the child prints it, too
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("extremes: no child process");
  if (child == 0) answerInto(ends[1], method, scene);
  close(ends[1]);
  Faults faults;
  for (const Placement& placement : scene.placements) {
    char answer = kFailed;
    ++faults.asked;
    if (read(ends[0], &answer, 1) != 1 || answer == kFailed) {
      ++faults.failed;
    } else if ((answer == kHit) != placement.collides) {
      ++faults.wrong;
    }
  }
  close(ends[0]);
  int status;
  waitpid(child, &status, 0);
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
    for (const Kind kind : {Kind::Convex, Kind::Slim, Kind::Starred, Kind::WithHole}) {
      const Scene plain = makeScene("", "", workloads::makePolygon(kind, 8, 1), workloads::makePolygon(kind, 8, 2));
      Scene scene = sweep.scene(kind, sweep.exponents[e]);
      scene.name = workloads::name(kind) + ", " + sweep.name + " 1e" + std::to_string(sweep.exponents[e]);
      scene.placements = placementsAroundContact(scene, contacts, 3, 5);
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

std::string power(int exponent) { return "1e" + std::to_string(exponent); }

const char* const kHow =
    R"(- Polygons of 8 vertices (round and slim convex, starred, with hole), 100 units long before they are moved or
  scaled. Poses: around first contact as for the trade-off, at 1 ulp, 1e-13, 1e-10, 1e-7, 1e-4 and 0.1 of the size,
  either way. The truth is exact arithmetic's, on the doubles that remain after the move.
- vertices moved: both polygons' own coordinates are large, and so are the pose's. poses moved: the coordinates stay,
  both poses have a far translation; rivals that know one pose only (GEOS, Boost) get the fixed polygon's coordinates
  there.
- A number is the count of wrong answers out of those in the second column; methods for convex polygons are asked about
  those only. "fail": an exception, a crash, or no answer within 5 seconds, after which the rest counts as failed, too.
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
    for (const int exponent : sweep.exponents) lines[0].push_back(power(exponent));
    data += "# " + sweep.name + "\n";
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const std::string name = methods[m].name();
      lines.push_back({name, std::to_string(grid[m][0].asked)});
      for (std::size_t e = 0; e < sweep.exponents.size(); ++e) {
        const Faults& faults = grid[m][e];
        lines.back().push_back(faults.text());
        csv += sweep.name + ',' + power(sweep.exponents[e]) + ',' + name + ',' + std::to_string(faults.asked) + ',' +
               std::to_string(faults.wrong) + ',' + std::to_string(faults.failed) + '\n';
        char line[160];
        std::snprintf(line, sizeof line, "%zu %zu \"%s\" \"%s\" %.4f\n", e, m, name.c_str(),
                      power(sweep.exponents[e]).c_str(), faults.share());
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
