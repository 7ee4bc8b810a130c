// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "crowd.h"
#include "footprint.h"
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

/// All that is judged.
struct Measured {
  std::vector<Result> study, distances, impacts, rounds, discs;
  CrowdResult crowd;
  Result round_fleet;
  std::vector<Footprint> footprints;
};

std::vector<Target> judge(const Measured& measured);

/// As a Markdown table with a column "met", and one line a target.
std::string targetsTable(const std::vector<Target>& targets);
std::string targetsCsv(const std::vector<Target>& targets);

}  // namespace tricover::bench
