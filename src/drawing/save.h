// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tricover::detail {

/// Writes a file. One that is there is replaced only when the new one is whole.
/// \throws std::runtime_error where that fails; the text has the path
void saveText(const std::string& path, const std::string& text);

}  // namespace tricover::detail
