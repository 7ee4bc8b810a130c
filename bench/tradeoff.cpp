// SPDX-License-Identifier: BSD-3-Clause
// Counts wrong answers around first contact and at the extremes, measures what values are off by, and times both.

#include "tradeoff.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "measure.h"
#include "report.h"
#include "tradeoff_methods.h"

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

/// How one method did on one group of scenes, or on all scenes.
struct Score {
  std::string group, family, setting;
  std::size_t asked = 0, misses = 0, false_alarms = 0;
  double ns = 0;           ///< per query
  double worst_miss = -1;  ///< way back to first contact over the size; -1: none
  double worst_alarm = 0;  ///< distance over the size
  /// By Placement::offset.
  std::vector<std::size_t> asked_at = std::vector<std::size_t>(offsetNames().size(), 0);
  std::vector<std::size_t> wrong_at = std::vector<std::size_t>(offsetNames().size(), 0);

  std::size_t wrong() const { return misses + false_alarms; }
  std::string name() const { return setting.empty() ? family : family + " " + setting; }
  /// Enters the answers to a scene's placements, which took `ns_per_query` each. `hits` is sorted.
  void add(const Scene& scene, const Hits& hits, double ns_per_query);
};

std::vector<std::string> groupsOf(const std::vector<Score>& scores) {
  std::vector<std::string> groups;
  for (const Score& score : scores) {
    if (std::find(groups.begin(), groups.end(), score.group) == groups.end()) groups.push_back(score.group);
  }
  return groups;
}

std::string worstMiss(const Score& score) {
  if (score.worst_miss < 0) return "-";
  return score.worst_miss == 0 ? "touch" : formatted("%.0e", score.worst_miss);
}

std::string worstAlarm(const Score& score) {
  return score.false_alarms == 0 ? "-" : formatted("%.0e", score.worst_alarm);
}

void Score::add(const Scene& scene, const Hits& hits, double ns_per_query) {
  const auto count = static_cast<double>(scene.placements.size());
  ns = (ns * static_cast<double>(asked) + ns_per_query * count) / (static_cast<double>(asked) + count);
  for (std::size_t i = 0; i < scene.placements.size(); ++i) {
    const Placement& placement = scene.placements[i];
    const bool hit = std::binary_search(hits.begin(), hits.end(), static_cast<std::uint32_t>(i));
    ++asked;
    ++asked_at[placement.offset];
    if (hit == placement.collides) continue;
    ++wrong_at[placement.offset];
    const double gap = std::abs(placement.gap) / scene.size;
    if (hit) {
      ++false_alarms;
      worst_alarm = std::max(worst_alarm, gap);
    } else {
      ++misses;
      worst_miss = std::max(worst_miss, gap);
    }
  }
}

std::string tradeoffTables(const std::vector<Score>& scores) {
  std::string text;
  for (const std::string& group : groupsOf(scores)) {
    TextTable lines = {{"method", "ns per query", "misses", "false alarms", "worst miss", "worst false alarm"}};
    std::size_t asked = 0;
    for (const Score& score : scores) {
      if (score.group != group) continue;
      asked = score.asked;
      lines.push_back({score.name(), formatted("%.0f", score.ns), std::to_string(score.misses),
                       std::to_string(score.false_alarms), worstMiss(score), worstAlarm(score)});
    }
    text += "## " + group + " (" + std::to_string(asked) + " queries)\n\n" + markdown(lines) + "\n";
  }
  return text;
}

std::string tradeoffCsv(const std::vector<Score>& scores) {
  std::ostringstream out;
  out << "group,method,setting,queries,ns_per_query,misses,false_alarms,worst_miss,worst_false_alarm\n";
  for (const Score& s : scores) {
    out << '"' << s.group << "\",\"" << s.family << "\"," << s.setting << ',' << s.asked << ','
        << formatted("%.2f", s.ns) << ',' << s.misses << ',' << s.false_alarms << ','
        << (s.misses ? formatted("%.3e", s.worst_miss) : "") << ','
        << (s.false_alarms ? formatted("%.3e", s.worst_alarm) : "") << '\n';
  }
  return out.str();
}

void writeTradeoffData(const std::vector<Score>& scores, const std::string& directory) {
  // One gnuplot block a group and family: tolerance, ns, share of wrong answers.
  std::map<std::string, std::string> blocks;
  std::vector<Score> totals;  // a method, over all groups
  for (const Score& score : scores) {
    blocks[score.group + ": " + score.family] +=
        (score.setting.empty() ? "0" : score.setting) + " " + formatted("%.2f", score.ns) + " " +
        formatted("%.6g", static_cast<double>(score.wrong()) / static_cast<double>(score.asked)) + "\n";
    const auto same = [&](const Score& total) { return total.name() == score.name(); };
    auto total = std::find_if(totals.begin(), totals.end(), same);
    if (total == totals.end()) {
      totals.emplace_back();
      totals.back().family = score.family;
      totals.back().setting = score.setting;
      total = totals.end() - 1;
    }
    for (std::size_t offset = 0; offset < score.asked_at.size(); ++offset) {
      total->asked_at[offset] += score.asked_at[offset];
      total->wrong_at[offset] += score.wrong_at[offset];
    }
  }
  std::string front;
  for (const auto& [name, lines] : blocks) front += "# " + name + "\n" + lines + "\n\n";
  writeFile(directory + "/tradeoff.dat", front);

  // Column and row numbers, name of the row, name of the column, share.
  std::string accuracy;
  for (std::size_t row = 0; row < totals.size(); ++row) {
    for (std::size_t offset = 0; offset < offsetNames().size(); ++offset) {
      const auto asked = static_cast<double>(totals[row].asked_at[offset]);
      const auto wrong = static_cast<double>(totals[row].wrong_at[offset]);
      accuracy += std::to_string(offset) + " " + std::to_string(row) + " \"" + totals[row].name() + "\" \"" +
                  offsetNames()[offset] + "\" " + formatted("%.4f", asked > 0 ? wrong / asked : 0) + "\n";
    }
    accuracy += "\n";
  }
  writeFile(directory + "/accuracy.dat", accuracy);
}

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

  const bool kept = keepsItsWord(scores), right = runValueTradeoff(directory, full),
             right_anywhere = runExtremes(directory, full);
  return kept && right && right_anywhere ? 0 : 1;
}

}  // namespace
}  // namespace tricover::bench

int main(int argc, char** argv) { return tricover::bench::runStudy(argc, argv, tricover::bench::run); }
