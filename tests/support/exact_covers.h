// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tricover/scene.h"

namespace tricover::exact {

/// Whether the union of areas holds all of a part, and no boundary of the union is nearer to the part than the margin.
/// On rationals: the interiors by strips of x in which no two edges cross, the edges by the middles of their pieces.
bool covers(const std::vector<BodyPlacement>& areas, const Polygon& part, const Pose& pose, double margin);

}  // namespace tricover::exact
