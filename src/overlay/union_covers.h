// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pair/posed_pair.h"

namespace tricover::detail {

/// Whether the union of areas, each the second of a pair, holds all of the part, the first of every pair, inflated by a
/// margin. Exact; see covers().
bool unionCovers(const std::vector<PosedPair>& part_and_areas, double margin);

/// The same of one area.
bool areaCovers(const PosedPair& part_and_area, double margin);

}  // namespace tricover::detail
