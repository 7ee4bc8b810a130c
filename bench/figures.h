// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "report.h"

/// Figures that floors are about: what a program's CSV says of each cell, and how two methods compare there.
namespace tricover::bench {

/// All workloads, and what each method took.
using Cells = std::vector<Result>;

/// A figure of a cell, by a method's time or by several; nothing if the cell has no such method.
using Ns = std::function<std::optional<double>(const Result&)>;
using Holds = std::function<bool(const Result&)>;

struct Figure {
  double value;
  std::string cell;
};
using Figures = std::vector<Figure>;
using Take = std::function<Figures(const Cells&)>;

Ns method(const std::string& name);
Ns startsWith(const std::string& start);
Ns fastest(Role role);
/// The core as the workload has it used: with a PairCache where there is coherence.
std::optional<double> core(const Result& result);
/// The same number for every cell, so that a time itself can be a row: 1e3 makes microseconds of it.
Ns constant(double ns);
Ns scaled(double factor, Ns ns);
/// FCL's best solver of those that are called directly.
extern const Ns kFclSolver;
/// A query through FCL, in the slower order of its operands.
std::optional<double> slowerOrder(const Result& result);
Holds holds(std::function<bool(const Workload&)> workload);
Holds operator&&(const Holds& p, const Holds& q);
Holds operator||(const Holds& p, const Holds& q);
Holds operator!(const Holds& p);
Holds job(const std::string& name);
/// The workload's name, or the scene's, begins so.
Holds named(const std::string& start);
Holds on(const std::string& start);
Holds sized(std::size_t low, std::size_t high);
/// FCL's first box or support tells most queries.
extern const Holds kMostlyAtOnce;
/// `above` / `below` of every cell that is `chosen` and that has both.
Take ratios(Holds chosen, Ns above, Ns below);
/// The power of a size with which `ns` grows from the least to the largest `chosen` cell, for each scene and
/// workload: of equally many vertices, at least 64 (fewer have paths of their own), or of islands and a robot of 4.
Take growth(Holds chosen, Ns ns);
/// The longest of a cell's times.
std::optional<double> longest(const Result& result);

/// Appends what report.h's csv() wrote; nothing if there is no such file.
void readCells(const std::string& path, Cells& cells);

}  // namespace tricover::bench
