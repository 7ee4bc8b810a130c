// SPDX-License-Identifier: BSD-3-Clause
#include "targets.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>

#include "studies.h"

namespace tricover::bench {
namespace {

/// tricover's core as the workload has it used: with a PairCache where there is coherence.
std::optional<double> core(const Result& result) {
  return nsOf(result, isCoherent(result.workload.name) ? "cached" : "cold");
}
std::optional<double> viaFcl(const Result& result) { return nsOf(result, "via FCL"); }
std::optional<double> emptyCall(const Result& result) { return nsOf(result, "empty"); }
std::optional<double> bestRival(const Result& result) { return fastest(result, Role::Rival); }
std::optional<double> bestBox2d(const Result& result) { return fastest(result, Role::Box2d); }

using Ns = std::function<std::optional<double>(const Result&)>;
using Filter = std::function<bool(const Workload&)>;

std::vector<Figure> ratios(const std::vector<Result>& results, const Filter& holds, const Ns& above, const Ns& below) {
  std::vector<Figure> figures;
  for (const Result& result : results) {
    const auto numerator = above(result), denominator = below(result);
    if (!holds(result.workload) || !numerator || !denominator) continue;
    figures.push_back({*numerator / *denominator, cellName(result)});
  }
  return figures;
}

Filter named(std::vector<std::string> names) {
  return [names](const Workload& w) { return std::find(names.begin(), names.end(), w.name) != names.end(); };
}

/// By kind: contact with 1024 vertices each against contact with 64 each.
std::vector<Figure> growth(const std::vector<Result>& results) {
  std::map<std::string, double> small, large;
  for (const Result& result : results) {
    const Workload& w = result.workload;
    if (w.name != "contact" || w.vertices_fixed != w.vertices_moving) continue;
    if (w.vertices_fixed == 64) small[w.scene] = *core(result);
    if (w.vertices_fixed == 1024) large[w.scene] = *core(result);
  }
  std::vector<Figure> figures;
  for (const auto& [kind, ns] : large) figures.push_back({ns / small.at(kind), kind});
  return figures;
}

std::vector<Figure> perEdge(const std::vector<Footprint>& footprints, double Footprint::*figure) {
  std::vector<Figure> figures;
  for (const Footprint& f : footprints) figures.push_back({f.*figure, f.kind + " " + std::to_string(f.vertices)});
  return figures;
}

/// What is judged, one target after the other; those without a figure in this run are left out.
class Judge {
 public:
  void add(const std::string& subject, const std::string& compared, std::vector<Figure> figures, const Wanted& wanted) {
    if (!figures.empty()) targets.push_back(judged(subject, compared, std::move(figures), wanted));
  }

  void collisions(const std::vector<Result>& results);
  void distancesAndImpacts(const std::vector<Result>& distances, const std::vector<Result>& impacts);
  void rounds(const std::vector<Result>& rounds, const std::vector<Result>& discs, const Result& fleet);

  std::vector<Target> targets;
};

const std::string kCoreText = "best rival / core", kFclText = "best rival / via FCL";

const Filter kAny = [](const Workload&) { return true; };

void Judge::collisions(const std::vector<Result>& results) {
  const auto trajectories = named({"circular", "linear"}), near_misses = named({"gap 0.1", "gap 0.01"});
  const auto compare = [&](const std::string& subject, const Filter& holds, const Wanted& by_core,
                           const Wanted& by_fcl) {
    add(subject, kCoreText, ratios(results, holds, bestRival, core), by_core);
    add(subject, kFclText, ratios(results, holds, bestRival, viaFcl), by_fcl);
  };
  add("circular, linear", kCoreText, ratios(results, trajectories, bestRival, core), {true, 20, 100});
  add("circular, linear", "via FCL / empty function", ratios(results, trajectories, viaFcl, emptyCall), {false, 1.4});
  compare("gap 0.1, gap 0.01", near_misses, {true, 10}, {true, 5});
  compare("contact", named({"contact"}), {true, 10}, {true, 5});
  compare("near", named({"near"}), {true, 10}, {true, 5});
  compare("overlap", named({"overlap"}), {true, 20, 100}, {true, 8});
  for (const std::string& name : workloadNames()) {
    add("convex, slim 8 x 8, " + name, "Box2D, the faster call / core", ratios(results, named({name}), bestBox2d, core),
        {true, 2});
  }
  add("contact, 64 to 1024 vertices each", "core / core", growth(results), {false, 2.5});
  add("static 512..1024, moving 8..16", kCoreText,
      ratios(
          results, [](const Workload& w) { return w.vertices_fixed >= 512 && w.vertices_moving <= 16; }, bestRival,
          core),
      {true, 1});
  add("any cell, any workload", kCoreText, ratios(results, kAny, bestRival, core), {true, 1});
  add("price of exactness, contact", "core / plain double signs",
      ratios(results, named({"contact"}), core, [](const Result& r) { return nsOf(r, "plain signs"); }), {false, 1.2});
}

void Judge::distancesAndImpacts(const std::vector<Result>& distances, const std::vector<Result>& impacts) {
  const auto coherent = [](const Workload& w) { return isCoherent(w.name); };
  const auto apart = [](const Workload& w) { return w.name != "overlap"; };
  const Ns cold = [](const Result& r) { return nsOf(r, "cold"); };
  add("distance, any cell, without a cache", kCoreText, ratios(distances, apart, bestRival, cold), {true, 5});
  add("distance on trajectories", kCoreText, ratios(distances, coherent, bestRival, core), {true, 20});
  add("distance, any cell", kFclText, ratios(distances, apart, bestRival, viaFcl), {true, 5});
  add("distance of overlapping polygons", kFclText, ratios(distances, named({"overlap"}), bestRival, viaFcl),
      {true, 1});
  add("distance, convex, slim 8 x 8", "Box2D, the faster start / core", ratios(distances, apart, bestBox2d, core),
      {true, 1});
  add("time of impact", kCoreText, ratios(impacts, kAny, bestRival, core), {true, 10});
  add("time of impact", kFclText, ratios(impacts, kAny, bestRival, viaFcl), {true, 10});
  add("time of impact, convex, slim 8 x 8, turning", "Box2D / core",
      ratios(impacts, named({"turning"}), bestBox2d, core), {true, 1});
  add("time of impact, convex, slim 8 x 8, sliding", "Box2D, the faster of cast and impact / core",
      ratios(impacts, named({"sliding"}), bestBox2d, core), {true, 1.2});
}

/// Ours in the slower order of the operands, FCL in the faster one, with the faster solver.
void Judge::rounds(const std::vector<Result>& rounds, const std::vector<Result>& discs, const Result& fleet) {
  const std::string text = "FCL's own pair / via FCL, the slower order";
  const Ns ours = [](const Result& r) { return std::max(nsOf(r, "via FCL"), nsOf(r, "via FCL, swapped")); };
  const auto judgeQuery = [&](const std::string& subject, const std::vector<std::string>& names) {
    const auto upright = [names](const Workload& w) {
      return w.scene.rfind("tilted", 0) != 0 && std::find(names.begin(), names.end(), w.name) != names.end();
    };
    add(subject, text, ratios(rounds, upright, bestRival, ours), {true, 1});
  };
  judgeQuery("polygon and round shape, collide", {"collide"});
  judgeQuery("polygon and round shape, distance", {"distance"});
  judgeQuery("polygon and round shape, time of impact", {"sliding", "turning"});
  const Ns disc = [](const Result&r) { return nsOf(r, "disc"); }, gon = [](const Result&r) { return nsOf(r, "8-gon"); };
  add("polygon and disc", "core, disc / 8-gon", ratios(discs, kAny, disc, gon), {false, 1.3});
  add("fleet of 500 round robots, whole frames", "FCL Sphere / via FCL", ratios({fleet}, kAny, bestRival, viaFcl),
      {true, 1});
}

}  // namespace

std::vector<Target> judge(const Measured& measured) {
  Judge judge;
  judge.collisions(measured.study);
  judge.add("soups and overlapping rings", "FCL BVH / core", ratios(measured.soups, kAny, bestRival, core), {true, 2});
  judge.distancesAndImpacts(measured.distances, measured.impacts);
  judge.rounds(measured.rounds, measured.discs, measured.round_fleet);
  judge.add("memory of all that is derived", "per edge", perEdge(measured.footprints, &Footprint::bytes),
            {false, 160, 0, "bytes"});
  judge.add("building it", "per edge", perEdge(measured.footprints, &Footprint::ns), {false, 400, 0, "ns"});
  return judge.targets;
}

}  // namespace tricover::bench
