// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "measure.h"

namespace tricover::bench {

/// A head and its lines.
using TextTable = std::vector<std::vector<std::string>>;

/// Markdown that is aligned enough to be read as it is.
std::string markdown(const TextTable& table);

/// Three digits, or all before the point.
std::string shortNumber(double value);

/// By printf's format for one number.
std::string formatted(const char* format, double value);

/// A CSV field, in quotation marks if it has a comma.
std::string quotedField(const std::string& text);

/// One line on a terminal, none elsewhere.
void showProgress(std::size_t done, std::size_t total, const std::string& title);

/// The conditions of the times: machine, compiler, flags; and how the rivals are set up.
std::string machine(const Settings& settings);
std::string conditions(const Settings& settings);

struct Study {
  std::string title;
  std::vector<Result> results;
};

/// Writes `<directory>/<name>.md`, a table a study (one row a workload, one column a method, and who answered wrongly
/// how often) and how it was measured; and `<name>.csv`, one line a workload and method. False, after saying on stderr
/// which, if a method of ours didn't give the reference's answer every time.
bool writeStudies(const std::string& directory, const std::string& name, const std::vector<Study>& studies,
                  const std::string& how, const std::string& unit = "Nanoseconds per query");

/// Lines by the name of their block, of which gnuplot draws one (`index "name"`).
using Blocks = std::map<std::string, std::string>;
void writeBlocks(const std::string& path, const Blocks& blocks);

/// Throws std::runtime_error, naming the file, unless all of it is written.
void writeFile(const std::string& path, const std::string& content);

/// Every program defines this. Its main(), which is ours, calls it on `<existing report directory> [--full]` with
/// Google Benchmark made ready, and returns 2 and the usage where the arguments don't fit, 1 where it returns false or
/// throws.
bool run(const std::string& directory, bool full);

}  // namespace tricover::bench
