// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "hierarchy/hierarchy.h"

namespace tricover::detail {

/// Finds discs in the region, proves them, and puts them into the hierarchy, whose root box must be there; `local` is
/// the polygon's path in units, from S. O(n).
void findInnerDiscs(const PolygonData& polygon, const std::vector<Vec2>& local, Hierarchy& hierarchy);

/// How deep in the region points (in units) are, negative outside: of a thinned outline, in floats.
std::vector<double> thinnedDepths(const PolygonData& polygon, const std::vector<Vec2>& local,
                                  const std::vector<Vec2>& points);

/// The radius, in units, of a disc around `center` (also in units) that lies in the region; 0 if that can't be shown.
double provenRadius(const PolygonData& polygon, const std::vector<Vec2>& local, const Vec2& center);

}  // namespace tricover::detail
