// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "depth/deepest_point.h"

namespace tricover::detail {

/// The point of a part that is farthest from the union of some areas: each pair has the part first. Its nearest edge is
/// one of the first area, or -1. The search ends as soon as a point is farther than `enough`.
DeepestPoint excessOfUnion(const std::vector<PosedPair>& part_and_areas, double enough);

/// unionCovers(); with a negative margin the part may stick out by so much.
bool unionCoversBut(const std::vector<PosedPair>& part_and_areas, double margin);

}  // namespace tricover::detail
