// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "target.h"

/// A speckled map as one polygon, beside a Scene with a body for every island.
namespace tricover::bench {

struct IslandCost {
  std::size_t islands;
  std::string query;
  double polygon_ns, scene_ns;
  double dearest_ms;  ///< of the polygon's queries, prepared before the first
};

std::vector<IslandCost> measureIslands();
std::vector<Target> judgeIslands(const std::vector<IslandCost>& costs);

}  // namespace tricover::bench
