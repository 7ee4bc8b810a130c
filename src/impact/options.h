// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "numbers/errors.h"
#include "tricover/time_of_impact.h"

namespace tricover::detail {

inline void checkOptions(const ImpactOptions& options) {
  requireFiniteNotNegative(options.time_error, "time_error");
  requireFiniteNotNegative(options.margin, "margin");
}

}  // namespace tricover::detail
