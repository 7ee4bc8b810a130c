// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "measure.h"
#include "study.h"

/// Times of impact of random motions.
namespace tricover::bench {

/// The study's kinds, in the sizes of the distances.
std::vector<Cell> impactCells(bool full);

/// "sliding" motions keep their direction, "turning" ones turn by up to 150 degrees either way. Both come from near the
/// fixed polygon, into it or past it.
std::vector<Result> measureImpacts(const Cell& cell, const Settings& settings);

}  // namespace tricover::bench
