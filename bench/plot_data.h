// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "measure.h"

namespace tricover::bench {

/// Writes what plots.gp draws of these results: times.dat, grid.dat, distance.dat and impact.dat in the directory.
void writePlotData(const std::vector<Result>& study, const std::vector<Result>& distances,
                   const std::vector<Result>& impacts, const std::string& directory);

}  // namespace tricover::bench
