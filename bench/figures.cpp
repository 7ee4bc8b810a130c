// SPDX-License-Identifier: BSD-3-Clause
#include "figures.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <utility>

namespace tricover::bench {
namespace {

std::vector<std::string> fieldsOf(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

Role roleOf(const std::string& name) {
  return name == "ours" ? Role::Ours : name == "rival" ? Role::Rival : name == "box2d" ? Role::Box2d : Role::Floor;
}

/// The least time of the timings that `wanted` names.
template <class Wanted>
Ns least(Wanted wanted) {
  return [=](const Result& result) {
    std::optional<double> ns;
    for (const Timing& timing : result.timings)
      if (wanted(timing) && (!ns || timing.ns < *ns)) ns = timing.ns;
    return ns;
  };
}
}  // namespace

void readCells(const std::string& path, Cells& cells) {
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    const std::vector<std::string> f = fieldsOf(line);
    if (f.size() < 14) continue;
    const auto number = [&](std::size_t i) {
      return static_cast<std::size_t>(std::strtoull(f[i].c_str(), nullptr, 10));
    };
    const Workload workload{f[0], f[1], f[2], number(3), number(4), number(5)};
    const auto same = [](const Workload& p, const Workload& q) {
      return p.job == q.job && cellName(p) == cellName(q) && p.positions == q.positions;
    };
    if (cells.empty() || !same(cells.back().workload, workload)) cells.push_back({workload, {}, number(6), number(13)});
    cells.back().timings.push_back({f[8], roleOf(f[7]), std::strtod(f[9].c_str(), nullptr)});
  }
}

Ns method(const std::string& name) {
  return least([=](const Timing& timing) { return timing.name == name; });
}
Ns startsWith(const std::string& start) {
  return least([=](const Timing& timing) { return timing.name.rfind(start, 0) == 0; });
}
Ns fastest(Role role) {
  return least([=](const Timing& timing) { return timing.role == role; });
}
std::optional<double> core(const Result& result) {
  const auto cached = method("cached")(result);
  return cached ? cached : method("cold")(result);
}
Ns constant(double ns) {
  return [=](const Result&) { return std::optional<double>(ns); };
}
Ns scaled(double factor, Ns ns) {
  return [=](const Result& result) { return std::optional<double>(factor * *ns(result)); };
}
const Ns kFclSolver =
    least([](const Timing& timing) { return timing.role == Role::Rival && timing.name.rfind("FCL", 0) == 0; });
std::optional<double> slowerOrder(const Result& result) {
  const auto one = method("via FCL")(result), other = method("via FCL, swapped")(result);
  return one && other ? std::max(*one, *other) : one;
}

Holds holds(std::function<bool(const Workload&)> workload) {
  return [=](const Result& result) { return workload(result.workload); };
}
Holds operator&&(const Holds& p, const Holds& q) {
  return [=](const Result& result) { return p(result) && q(result); };
}
Holds operator||(const Holds& p, const Holds& q) {
  return [=](const Result& result) { return p(result) || q(result); };
}
Holds operator!(const Holds& p) {
  return [=](const Result& result) { return !p(result); };
}
Holds job(const std::string& name) {
  return holds([=](const Workload& w) { return w.job == name; });
}
Holds named(const std::string& start) {
  return holds([=](const Workload& w) { return w.name.rfind(start, 0) == 0; });
}
Holds on(const std::string& start) {
  return holds([=](const Workload& w) { return w.scene.rfind(start, 0) == 0; });
}
Holds sized(std::size_t low, std::size_t high) {
  return holds([=](const Workload& w) { return w.vertices_fixed >= low && w.vertices_fixed <= high; });
}
const Holds kMostlyAtOnce = [](const Result& cell) { return 2 * cell.decided_at_once > cell.workload.positions; };

Take ratios(Holds chosen, Ns above, Ns below) {
  return [=](const Cells& cells) {
    Figures figures;
    for (const Result& cell : cells) {
      if (!chosen(cell)) continue;
      const auto p = above(cell), q = below(cell);
      if (p && q) figures.push_back({*p / *q, cellName(cell.workload)});
    }
    return figures;
  };
}

Take growth(Holds chosen, Ns ns) {
  return [=](const Cells& cells) {
    std::map<std::string, std::pair<const Result*, const Result*>> ends;
    for (const Result& cell : cells) {
      const Workload& w = cell.workload;
      if (!chosen(cell) || !ns(cell) || (w.job != "islands" && w.vertices_fixed != w.vertices_moving) ||
          w.vertices_fixed < 64)
        continue;
      auto& [low, high] = ends.try_emplace(w.scene + ", " + w.name, &cell, &cell).first->second;
      if (w.vertices_fixed < low->workload.vertices_fixed) low = &cell;
      if (w.vertices_fixed > high->workload.vertices_fixed) high = &cell;
    }
    Figures figures;
    for (const auto& [name, pair] : ends) {
      const auto& [low, high] = pair;
      if (low == high) continue;
      const double more =
          static_cast<double>(high->workload.vertices_fixed) / static_cast<double>(low->workload.vertices_fixed);
      figures.push_back({std::log(*ns(*high) / *ns(*low)) / std::log(more), name});
    }
    return figures;
  };
}

std::optional<double> longest(const Result& result) {
  double most = 0;
  for (const Timing& timing : result.timings) most = std::max(most, timing.ns);
  return most;
}

}  // namespace tricover::bench
