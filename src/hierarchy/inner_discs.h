// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "hierarchy/hierarchy.h"

namespace tricover::detail {

/// Finds discs in the region, proves them, and puts them into the hierarchy, whose root box must be there; `local` is
/// the polygon's path in units, from S. O(n).
void findInnerDiscs(const PolygonData& polygon, const std::vector<Vec2>& local, Hierarchy& hierarchy);

}  // namespace tricover::detail
