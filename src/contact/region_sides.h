// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "polygon/polygon_data.h"

namespace tricover::detail {

struct RegionSides {
  /// On which side of each ring's edges the region is, in the polygon's frame. 1: on the left; -1: on the right; 0: on
  /// both, or unknown, as where edges meet or rings are too many.
  std::vector<std::int8_t> rings;
  /// At so many corners, on average over directions, an edge of another region may lie against one of the rings.
  double corners = 0;
};

/// Found at the first call, once for all copies and threads.
const RegionSides& regionSidesOf(const PolygonData& polygon);

}  // namespace tricover::detail
