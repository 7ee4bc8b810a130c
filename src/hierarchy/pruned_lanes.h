// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "polygon/polygon_data.h"

namespace tricover::detail {

/// For PrunedPairs: the lanes of a polygon's hierarchy that hold none but these edges, by position in the path.
std::vector<std::uint8_t> prunedLanes(const PolygonData& polygon, const std::vector<bool>& edges);

}  // namespace tricover::detail
