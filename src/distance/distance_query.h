// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "numbers/errors.h"
#include "tricover/distance.h"

namespace tricover::detail {

/// What is asked: of a distance above the limit, that it is.
struct DistanceQuery : DistanceOptions {
  double limit = std::numeric_limits<double>::infinity();
};

inline void checkOptions(const DistanceOptions& options) {
  requireNotNegative(options.relative_error, "relative_error");
  requireNotNegative(options.absolute_error, "absolute_error");
  requireFiniteNotNegative(options.margin, "margin");
}

}  // namespace tricover::detail
