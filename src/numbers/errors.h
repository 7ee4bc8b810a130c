// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <stdexcept>
#include <string>

namespace tricover::detail {

/// The text of every exception: "tricover: <field>[: ring i, vertex j]: <what is wrong>[; <what to do instead>]".
inline std::string refusal(const std::string& field, const std::string& wrong, const std::string& instead = {}) {
  return "tricover: " + field + ": " + wrong + (instead.empty() ? "" : "; " + instead);
}

[[noreturn]] inline void refuse(const std::string& field, const std::string& wrong, const std::string& instead = {}) {
  throw std::invalid_argument(refusal(field, wrong, instead));
}

/// Of a length or another number, infinity included. Written so that NaN fails, as below.
inline void requireNotNegative(double value, const char* field) {
  if (!(value >= 0)) refuse(field, "it must be a number and not negative");
}

inline void requireFiniteNotNegative(double value, const char* field) {
  if (!(value >= 0 && value <= std::numeric_limits<double>::max())) refuse(field, "it must be finite and not negative");
}

}  // namespace tricover::detail
