// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>

#include "extremes.h"
#include "measure.h"
#include "report.h"
#include "tradeoff_report.h"
#include "value_extremes.h"
#include "value_tradeoff.h"

namespace tricover::bench {
namespace {

const char* const kHow =
    R"(- First contact is found by bisection on exact rational arithmetic, for random turns and directions of approach;
  poses are then set back or forth along the direction, by 1 ulp and by 1e-15 .. 1e-1 of the size. Touches are
  constructed on a dyadic grid, under quarter turns. The truth about each pose's doubles is exact arithmetic's.
- size: the larger bounding disc's diameter. A worst miss is the way back along the direction to first contact, a worst
  false alarm the exact distance, both as parts of the size.
- bounding discs, influence areas: the first and the second step of the paper's Algorithm 3 taken as the answer.
- tolerance: CollideOptions::tolerance as a part of the size. plain double, plain float: the same kernel, its signs
  computed in plain doubles or floats, without filter and exact stage.
- FCL's tolerances are its gjk_tolerance (distance_tolerance for the libccd GJK), called directly, without dispatch. MPR
  is what fcl::collide runs for GST_LIBCCD, GJK (libccd) what fcl::distance runs; indep is GST_INDEP.
- GEOS, Boost and BVH work on rounded, transformed coordinates, Box2D on floats: their errors are counted as they are.
)";

/// Scores of all methods on all scenes, by group.
std::vector<Score> scoreAll(const std::vector<Scene>& scenes, const Settings& settings) {
  std::vector<Score> scores;
  for (const Scene& scene : scenes) {
    const std::size_t positions = scene.placements.size();
    Hits truth;
    for (std::size_t i = 0; i < positions; ++i) {
      if (scene.placements[i].collides) truth.push_back(static_cast<std::uint32_t>(i));
    }
    std::vector<const Method*> methods;
    std::vector<Contender> contenders = {{"truth", Role::Floor, false, [&](const Sampling& sampling, Hits& hits) {
                                            for (const std::uint32_t hit : truth) {
                                              if (sampling.holds(hit)) hits.push_back(hit);
                                            }
                                          }}};
    for (const Method& method : tradeoffMethods()) {
      if (!method.takes(scene)) continue;
      methods.push_back(&method);
      contenders.push_back(method.make(scene));
    }
    const Workload workload{
        "tradeoff", scene.group, scene.name, scene.fixed.vertexCount(), scene.moving.vertexCount(), positions, 1};
    const Result result = measure(workload, contenders, settings);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const Method& method = *methods[m];
      const Timing& timing = result.timings[m + 1];
      if (method.family == kExact && timing.misses + timing.false_alarms > 0) {
        throw std::logic_error("tradeoff: wrong while it was timed: " + scene.name);
      }
      const auto same = [&](const Score& score) { return score.group == scene.group && score.name() == method.name(); };
      auto score = std::find_if(scores.begin(), scores.end(), same);
      if (score == scores.end()) {
        scores.emplace_back();
        scores.back().group = scene.group;
        scores.back().family = method.family;
        scores.back().setting = method.setting;
        score = scores.end() - 1;
      }
      Hits hits;
      contenders[m + 1].walk(Sampling{}, hits);
      score->add(scene, hits, timing.ns);
    }
  }
  return scores;
}

/// No wrong answer with tolerance 0; no miss, and no false alarm beyond the tolerance, with another.
bool keepsItsWord(const std::vector<Score>& scores) {
  bool keeps = true;
  for (const Score& score : scores) {
    if (score.family != kExact && score.family != kTolerance) continue;
    const double tolerance = score.setting.empty() ? 0 : std::stod(score.setting);
    if (score.misses == 0 && (score.false_alarms == 0 || (tolerance > 0 && score.worst_alarm <= tolerance))) continue;
    std::fprintf(stderr, "error: %s broke its word on %s\n", score.name().c_str(), score.group.c_str());
    keeps = false;
  }
  return keeps;
}

int run(const std::string& data, const std::string& directory, bool full) {
  std::ifstream in(data);
  if (!in) throw std::runtime_error("cannot read " + data);
  const auto countries = workloads::readPolygons(in);

  const Settings settings = full ? Settings{5, 0.02} : Settings{5, 0.002};
  const std::vector<Score> scores = scoreAll(tradeoffScenes(countries, full), settings);
  const std::string tables = "# Speed against accuracy, around first contact\n\n" + tradeoffTables(scores);
  writeFile(directory + "/tradeoff.md", tables + "# How it was measured\n\n" + kHow);
  writeFile(directory + "/tradeoff.csv", tradeoffCsv(scores));
  writeTradeoffData(scores, directory);

  const bool kept = keepsItsWord(scores), stable = runExtremes(directory, full),
             right = runValueTradeoff(directory, full), right_anywhere = runValueExtremes(directory, full);
  return kept && stable && right && right_anywhere ? 0 : 1;
}

}  // namespace
}  // namespace tricover::bench

int main(int argc, char** argv) { return tricover::bench::runStudy(argc, argv, tricover::bench::run); }
