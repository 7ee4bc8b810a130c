// SPDX-License-Identifier: BSD-3-Clause
#include "tradeoff_report.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "report.h"

namespace tricover::bench {
namespace {

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

}  // namespace

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

}  // namespace tricover::bench
