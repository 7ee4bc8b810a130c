// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "numbers/errors.h"
#include "tricover/distance.h"

namespace tricover::detail {

inline void checkOptions(const DistanceOptions& options) {
  requireNotNegative(options.relative_error, "relative_error");
  requireNotNegative(options.absolute_error, "absolute_error");
  requireNotNegative(options.limit, "limit");
  requireFiniteNotNegative(options.margin, "margin");
}

}  // namespace tricover::detail
