// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers/errors.h"
#include "numbers/motion.h"
#include "tricover/impact.h"

namespace tricover::detail {

inline void checkOptions(const ImpactOptions& options) {
  requireFiniteNotNegative(options.time_error, "time_error");
  requireFiniteMargin(options.margin, "margin");
}

/// The options for a motion over an interval of that length, which may be 0, as time from 0 to 1.
inline ImpactOptions optionsWithin(const ImpactOptions& options, double length) {
  return {options.margin, std::min(1.0, options.time_error / length), false};
}

/// When such a motion comes to a time, rounded down where it is rounded: an impact is told no later than it is.
inline double timeWithin(double begin, double length, double share) {
  if (begin == 0 && length == 1) return share;
  constexpr double kDown = -std::numeric_limits<double>::infinity();
  return share > 0 ? std::max(begin, std::nextafter(begin + length * share, kDown)) : begin;
}

}  // namespace tricover::detail
