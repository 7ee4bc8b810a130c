// SPDX-License-Identifier: BSD-3-Clause
// Counts wrong answers around first contact and at the extremes, measures what values are off by, and times both.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "measure.h"
#include "report.h"
#include "value_problems.h"

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
  /// By KnownPose::offset.
  std::vector<std::size_t> asked_at = std::vector<std::size_t>(offsetNames().size(), 0);
  std::vector<std::size_t> wrong_at = std::vector<std::size_t>(offsetNames().size(), 0);

  std::size_t wrong() const { return misses + false_alarms; }
  std::string name() const { return setting.empty() ? family : family + ", " + setting; }
  /// Enters the answers at a scene's poses, which took `ns_per_query` each. `hits` is sorted.
  void add(const KnownScene& scene, const Hits& hits, double ns_per_query);
};

/// In the order of first appearance.
Score& scoreOf(std::vector<Score>& scores, const std::string& group, const std::string& family,
               const std::string& setting) {
  const auto found = std::find_if(scores.begin(), scores.end(), [&](const Score& score) {
    return score.group == group && score.family == family && score.setting == setting;
  });
  if (found != scores.end()) return *found;
  scores.push_back({group, family, setting});
  return scores.back();
}

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

void Score::add(const KnownScene& scene, const Hits& hits, double ns_per_query) {
  const auto count = static_cast<double>(scene.poses.size());
  ns = (ns * static_cast<double>(asked) + ns_per_query * count) / (static_cast<double>(asked) + count);
  for (std::size_t i = 0; i < scene.poses.size(); ++i) {
    const KnownPose& known = scene.poses[i];
    const bool hit = std::binary_search(hits.begin(), hits.end(), static_cast<std::uint32_t>(i));
    ++asked;
    ++asked_at[known.offset];
    if (hit == known.collides) continue;
    ++wrong_at[known.offset];
    const double gap = std::abs(known.gap) / scene.size;
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
  Blocks blocks;              // a group and family: tolerance, ns, share of wrong answers
  std::vector<Score> totals;  // a method, over all groups
  for (const Score& score : scores) {
    blocks[score.group + ": " + score.family] +=
        (score.setting.empty() ? "0" : score.setting) + " " + formatted("%.2f", score.ns) + " " +
        formatted("%.6g", static_cast<double>(score.wrong()) / static_cast<double>(score.asked)) + "\n";
    Score& total = scoreOf(totals, "", score.family, score.setting);
    for (std::size_t offset = 0; offset < score.asked_at.size(); ++offset) {
      total.asked_at[offset] += score.asked_at[offset];
      total.wrong_at[offset] += score.wrong_at[offset];
    }
  }
  writeBlocks(directory + "/tradeoff.dat", blocks);

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
std::vector<Score> scoreAll(const std::vector<KnownScene>& scenes, const Settings& settings) {
  std::vector<Score> scores;
  for (const KnownScene& scene : scenes) {
    const std::size_t positions = scene.poses.size();
    Hits truth;
    for (std::size_t i = 0; i < positions; ++i) {
      if (scene.poses[i].collides) truth.push_back(static_cast<std::uint32_t>(i));
    }
    const std::vector<CollisionMethod> methods = collisionMethods(scene, isConvexPair(scene));
    std::vector<Contender> contenders = {{"truth", Role::Floor, false, [&](const Sampling& sampling, Hits& hits) {
                                            for (const std::uint32_t hit : truth) {
                                              if (sampling.holds(hit)) hits.push_back(hit);
                                            }
                                          }}};
    for (const CollisionMethod& method : methods) {
      contenders.push_back(method.make());
      contenders.back().name = method.name();
    }
    const Workload workload{"tradeoff", scene.group, scene.name, scene.fixed.vertexCount(), scene.moving.vertexCount(),
                            positions};
    const Result result = measure(workload, contenders, settings);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const CollisionMethod& method = methods[m];
      const Timing& timing = result.timings[m + 1];
      if (method.family == kExact && timing.misses + timing.false_alarms > 0) {
        throw std::logic_error("tradeoff: wrong while it was timed: " + scene.name);
      }
      Hits hits;
      contenders[m + 1].walk(Sampling{}, hits);
      scoreOf(scores, scene.group, method.family, method.setting).add(scene, hits, timing.ns);
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

}  // namespace

bool run(const std::string& directory, bool full) {
  const Settings settings = full ? Settings{5, 0.02} : Settings{5, 0.002};
  const std::vector<Score> scores = scoreAll(tradeoffScenes(full), settings);
  const std::string tables = "# Speed against accuracy, around first contact\n\n" + tradeoffTables(scores);
  writeFile(directory + "/tradeoff.md", tables + "# How it was measured\n\n" + kHow);
  writeFile(directory + "/tradeoff.csv", tradeoffCsv(scores));
  writeTradeoffData(scores, directory);

  const bool kept = keepsItsWord(scores), right = runValueTradeoff(directory, full),
             right_anywhere = runExtremes(directory, full);
  return kept && right && right_anywhere;
}

}  // namespace tricover::bench
