// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <fstream>
#include <istream>
#include <string>

namespace tricover::detail {

/// Throws std::runtime_error: "tricover: <file>[: <field>]: <what is wrong>[; <what to do instead>]".
[[noreturn]] void refuseFile(const std::string& file, const std::string& wrong, const std::string& instead = {});

/// What a reader reads: a file, or bytes in memory.
struct Input {
  std::istream& in;     ///< in the classic locale, at its start
  std::uintmax_t size;  ///< in bytes
  std::string name;     ///< for errors
};

/// Opens a plain file. A device or a pipe has no size, and reading one might never end.
Input openFile(std::ifstream& file, const std::string& path);

/// A to Z as a to z.
std::string lowered(std::string text);

/// All of a plain file.
std::string readText(const std::string& path);

}  // namespace tricover::detail
