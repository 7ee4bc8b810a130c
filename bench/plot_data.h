// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "measure.h"

namespace tricover::bench {

/// Writes what plots.gp draws of the study's results: `<directory>/times.dat` and `<directory>/grid.dat`.
void writePlotData(const std::vector<Result>& results, const std::string& directory);

}  // namespace tricover::bench
