// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "target.h"

/// What a PairCache costs where its facts help and where they don't.
namespace tricover::bench {

struct CacheCost {
  std::string polygons, walk, query;
  double none_ns, cached_ns;
};

/// Triangles to outlines of 512 vertices; resting on each other, beside each other, in steps and jumps.
std::vector<CacheCost> measureCaches();
std::vector<Target> judgeCaches(const std::vector<CacheCost>& costs);

}  // namespace tricover::bench
