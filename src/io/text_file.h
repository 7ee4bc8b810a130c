// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tricover::detail {

/// All of a plain file. A device or a pipe has no size, and reading one might never end. Throws std::runtime_error.
std::string readText(const std::string& path);

/// Replaces a file. Throws std::runtime_error.
void writeText(const std::string& path, const std::string& text);

}  // namespace tricover::detail
