// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>
#include <string>

namespace tricover::detail {

/// The shortest text that is read as this double, the same in every locale.
inline std::string shortest(double number) {
  char text[32];  // 24 at most
  return std::string(text, std::to_chars(text, text + sizeof text, number).ptr);
}

}  // namespace tricover::detail
