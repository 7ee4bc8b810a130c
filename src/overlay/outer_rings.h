// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "polygon/polygon_data.h"

namespace tricover::detail {

/// Rings of fewer corners whose region covers the polygon's, see Polygon::simplified().
std::vector<Ring> outerRings(const PolygonData& polygon, double tolerance);

}  // namespace tricover::detail
