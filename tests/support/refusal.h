// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace tricover::support {

/// The text of the exception that a call ends with; empty if it doesn't.
template <typename Exception = std::invalid_argument, typename Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const Exception& error) {
    return error.what();
  }
  return {};
}

}  // namespace tricover::support
