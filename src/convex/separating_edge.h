// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "hierarchy/placement.h"

namespace tricover::detail {

/// Whether all of one polygon is certainly beyond the line of the other's edge, a convex one's: a separating axis in
/// doubles, where floats can't tell.
bool isSeparatingEdge(const Placement& placement, bool of_a, std::size_t edge);

}  // namespace tricover::detail
