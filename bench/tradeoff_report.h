// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tradeoff_methods.h"

namespace tricover::bench {

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

/// One Markdown table a group: time, wrong answers, and the worst of them.
std::string tradeoffTables(const std::vector<Score>& scores);

std::string tradeoffCsv(const std::vector<Score>& scores);

/// Writes what tradeoff.gp draws: `<directory>/tradeoff.dat`, the front, and `<directory>/accuracy.dat`, the share of
/// wrong answers by offset.
void writeTradeoffData(const std::vector<Score>& scores, const std::string& directory);

}  // namespace tricover::bench
