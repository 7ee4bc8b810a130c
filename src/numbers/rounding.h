// SPDX-License-Identifier: BSD-3-Clause
//
// What every bound in the kernel assumes:
//   - doubles and floats are IEC 559's, and each operation on them rounds by itself: contraction is off in the core's
//     targets (CMakeLists.txt), and -ffast-math is refused (tricover/pose.h);
//   - the thread rounds to nearest, which is how every thread starts; nobody who calls fesetround() is checked;
//   - denormals may be flushed to zero: kTiny and its like pay for that, too;
//   - GCC or Clang: vector extensions, __builtin_ctz, unsigned __int128.
#pragma once

#include <cfloat>
#include <cmath>
#include <limits>

#if !defined(__GNUC__)
#error "tricover needs GCC or Clang: it is written in their vector extensions"
#endif
#if FLT_EVAL_METHOD != 0
#error "tricover's bounds hold where doubles are rounded to doubles: not for x87 arithmetic (use -msse2 -mfpmath=sse)"
#endif
#if !defined(__SIZEOF_INT128__)
#error "tricover needs unsigned __int128: compile for a 64-bit target"
#endif

namespace tricover::detail {

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53);
static_assert(std::numeric_limits<float>::is_iec559 && std::numeric_limits<float>::digits == 24);
static_assert(std::numeric_limits<double>::round_style == std::round_to_nearest);

/// The unit roundoff U, half an ulp of 1: a rounded operation errs by at most this, relatively.
constexpr double kUnitRoundoff = 0x1p-53;
/// Covers what a few operations lose to underflow: 2^-1075 each, or 2^-1022 where the host flushes denormals to zero.
constexpr double kTiny = 0x1p-1010;

constexpr double kRoot2 = 1.41421357;  ///< rounded up

/// At least what n roundings in a row change a number by, relatively: (1 + U)^n - 1 and 1 - (1 - U)^n are below
/// n U / (1 - n U), which is less than (n + 2^-20) U for n < 2^16.
constexpr double errorOf(int n) { return (n + 0x1p-20) * kUnitRoundoff; }

/// A number that n roundings may have made too small, made large enough: x >= (1 - U)^n y gives, with f = 1 + m U and
/// one more rounding, x f (1 - U) >= (1 - U)^(n + 1) (1 + m U) y >= y for m >= n + 2. Doubles above 1 are 2U apart.
template <int n>
constexpr double roundedUp(double x) {
  return x * (1 + (n + 3) / 2 * 2 * kUnitRoundoff);
}

/// The other way: (1 + U)^(n + 1) (1 - m U) <= 1 for m >= n + 1.
template <int n>
constexpr double roundedDown(double x) {
  return x * (1 - (n + 1) * kUnitRoundoff);
}

/// Whether the square of this length, and of a good many times it, neither overflows nor loses digits.
inline bool squarable(double length) { return length > 0x1p-480 && length < 0x1p480; }

/// A lower bound of the length of (x, y): tight, but 0 where the squares overflow or lose digits to underflow. The sum
/// of the squares is rounded twice, which the root halves, and the root once.
inline double normBelow(double x, double y) {
  const double square = x * x + y * y;
  return square > 0x1p-960 && square <= std::numeric_limits<double>::max() ? roundedDown<2>(std::sqrt(square)) : 0;
}

}  // namespace tricover::detail
