// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "polygon/polygon_data.h"

namespace tricover::detail {

/// For SettledPairs: the lanes of a polygon's hierarchy that hold none but these edges, by position in the path.
std::vector<std::uint8_t> settledLanes(const PolygonData& polygon, const std::vector<bool>& edges);

}  // namespace tricover::detail
