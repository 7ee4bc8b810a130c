// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
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

/// A Markdown table, one row a workload, one column a method; and who answered wrongly how often.
std::string table(const std::vector<Result>& results, const std::string& unit = "Nanoseconds per query");

/// One line a workload and method.
std::string csv(const std::vector<Result>& results);

/// Whether every method of ours gave the reference's answer every time; says on stderr which didn't.
bool oursAgree(const std::vector<Result>& results);

/// One line on a terminal, none elsewhere.
void showProgress(std::size_t done, std::size_t total, const std::string& title);

/// What must be known to read the times: machine, compiler, flags; and how the rivals are set up.
std::string machine(const Settings& settings);
std::string conditions(const Settings& settings);

/// What main() does: 2 and the usage where the arguments don't fit, 1 and what was thrown, or what `run` returns.
int runProgram(const char* program, const char* usage, bool fits, const std::function<int()>& run);

/// Throws std::runtime_error, naming the file, unless all of it is written.
void writeFile(const std::string& path, const std::string& content);

}  // namespace tricover::bench
