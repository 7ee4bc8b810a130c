// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "target.h"

/// What a narrow gap costs: bodies that turn or slide so close to another one.
namespace tricover::bench {

constexpr std::array<double, 6> kGaps = {1e-3, 1e-6, 1e-9, 1e-11, 1e-12, 1e-13};

struct GapCost {
  std::string input, query;
  std::array<double, kGaps.size()> seconds;  ///< CPU time a query
};

std::vector<GapCost> measureGaps();
std::string gapTable(const std::vector<GapCost>& costs);
std::string gapCsv(const std::vector<GapCost>& costs);

/// Times of impact below a millisecond, whatever the gap; no step in what small convex pairs cost.
std::vector<Target> judgeGaps(const std::vector<GapCost>& costs);

}  // namespace tricover::bench
