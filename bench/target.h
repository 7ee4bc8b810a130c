// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measure.h"

namespace tricover::bench {

/// One thing that was promised, and what came of it.
struct Target {
  std::string subject, compared;  ///< on what, and what is divided by what
  std::string wanted;
  std::string unit;  ///< "x", "bytes" or "ns"
  double worst, median;
  std::string worst_cell;
  bool met;
};

/// A figure and the cell that it is from.
struct Figure {
  double value;
  std::string cell;
};

/// What is wanted of all figures: each at least (or at most) `every`, and the median at least `median`.
struct Wanted {
  bool at_least;
  double every;
  double median = 0;
  std::string unit = "x";
};

Target judged(std::string subject, std::string compared, std::vector<Figure> figures, const Wanted& wanted);

/// "scene vertices, workload".
std::string cellName(const Result& result);

/// The method's time, and that of the fastest one in that role; nothing if there is none.
std::optional<double> nsOf(const Result& result, const std::string& method);
std::optional<double> fastest(const Result& result, Role role);

/// As a Markdown table with a column "met", and one line a target.
std::string targetsTable(const std::vector<Target>& targets);
std::string targetsCsv(const std::vector<Target>& targets);

}  // namespace tricover::bench
