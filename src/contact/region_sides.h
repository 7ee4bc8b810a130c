// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "polygon/polygon_data.h"

namespace tricover::detail {

struct RingSide {
  /// On which side of the ring's edges the region is, in the polygon's frame: 1: on the left of each; -1: on the right;
  /// 0: on both, or nobody knows, as where edges meet or rings are too many.
  std::int8_t side = 0;
  bool is_hole = false;  ///< certainly: it is simple, meets no other one, and is around what isn't in the region
  /// At so many corners, on average over directions, an edge of another region may lie against the ring's.
  double corners = 0;
  /// The diameter: at least, or of a hole at most. Rounded by a few U.
  double diameter = 0;
};

struct RegionSides {
  std::vector<RingSide> rings;
  double least_part = 0;  ///< no connected part of the region is smaller in diameter, but for a few U
};

/// Whether a ring may bound the free translations of another region, posed. In a hole that is smaller than each of its
/// parts there are none, and what touches the hole's ring from outside of the region is in the hole.
bool mayBound(const RingSide& ring, const RegionSides& other);

/// Found at the first call, once for all copies and threads.
const RegionSides& regionSidesOf(const PolygonData& polygon);

}  // namespace tricover::detail
