// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "footprint.h"
#include "measure.h"
#include "target.h"

namespace tricover::bench {

/// All that is judged.
struct Measured {
  std::vector<Result> study, distances, impacts, contacts, rounds, discs, soups;
  Result round_fleet;
  std::vector<Footprint> footprints;
};

std::vector<Target> judge(const Measured& measured);

}  // namespace tricover::bench
