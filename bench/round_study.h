// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "measure.h"

/// Round bodies: discs of our own and FCL's sphere, cylinder, capsule, cone and ellipsoid, beside FCL's own pairs of
/// the same kind.
namespace tricover::bench {

/// Through FCL: polygons of 4 (a rectangle), 8 and 64 vertices, and a disc, against each round body; collide, distance
/// and conservative advancement, in both orders of the operands.
std::vector<Result> measureRounds(const Settings& settings);

}  // namespace tricover::bench
