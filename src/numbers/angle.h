// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tricover::detail {

constexpr double kPi = 3.14159265358979323846;

}  // namespace tricover::detail
