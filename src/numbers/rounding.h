// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>

namespace tricover::detail {

/// The unit roundoff U, half an ulp of 1: a rounded operation errs by at most this, relatively.
constexpr double kUnitRoundoff = 0x1p-53;
/// Covers what a few operations lose to underflow: 2^-1075 each, or 2^-1022 where the host flushes denormals to zero.
constexpr double kTiny = 0x1p-1010;

/// Whether the square of this length, and of a good many times it, neither overflows nor loses digits.
inline bool squarable(double length) { return length > 0x1p-480 && length < 0x1p480; }

/// A lower bound of the length of (x, y): tight, but 0 where the squares overflow or lose digits to underflow. 4
/// roundings.
inline double normBelow(double x, double y) {
  const double square = x * x + y * y;
  return square > 0x1p-960 && square <= std::numeric_limits<double>::max() ? std::sqrt(square) * (1 - 4 * kUnitRoundoff)
                                                                           : 0;
}

}  // namespace tricover::detail
