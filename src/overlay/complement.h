// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "polygon/polygon_data.h"

namespace tricover::detail {

struct BorderRings {
  std::vector<Ring> rings;
  std::vector<EdgePosition> edges;  ///< by the numbers of the rings' edges: positions in the given polygon
};

/// Rings of all edges that have the region on one side alone, for the even-odd rule; nothing if the polygon's own rings
/// are these, no rings if there is no interior. Corners are rounded where rings of the non-zero rule cross away from
/// vertices.
std::optional<BorderRings> borderRings(const PolygonData& polygon);

}  // namespace tricover::detail
