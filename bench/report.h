// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "measure.h"

namespace tricover::bench {

/// The results of one job as a Markdown table, one row a workload, one column a method.
std::string table(const std::vector<Result>& results, const std::string& job);

/// One line a workload and method.
std::string csv(const std::vector<Result>& results);

/// What must be known to read the times: machine, compiler, flags, how the rivals are set up.
std::string conditions(const Settings& settings);

/// Writes the data that plots.gp draws: `<directory>/times.dat` and `<directory>/grid.dat`.
void writePlotData(const std::vector<Result>& results, const std::string& directory);

/// Throws std::runtime_error, naming the file, unless all of it is written.
void writeFile(const std::string& path, const std::string& content);

}  // namespace tricover::bench
