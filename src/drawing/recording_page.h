// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tricover::detail {

/// The HTML document around a recording's data, which is safe within a script element.
std::string recordingPage(const std::string& data);

}  // namespace tricover::detail
