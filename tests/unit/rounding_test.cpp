// SPDX-License-Identifier: BSD-3-Clause
// The laws of the helpers that error bounds are written with, on exact rationals.
#include "numbers/rounding.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "numbers/sine.h"
#include "random.h"

namespace tricover::support {
namespace {

using detail::kUnitRoundoff;

mpq_class power(const mpq_class& base, int n) {
  mpq_class result(1);
  for (int i = 0; i < n; ++i) result *= base;
  return result;
}

TEST(UnitRoundoff, IsWhatAnOperationErrsBy) {
  EXPECT_EQ(kUnitRoundoff, std::numeric_limits<double>::epsilon() / 2);
  // Half way between two doubles, and just beyond.
  EXPECT_EQ(1 + kUnitRoundoff, 1);
  EXPECT_EQ(1 + std::nextafter(kUnitRoundoff, 1.0), 1 + 2 * kUnitRoundoff);
}

TEST(ErrorOf, CoversAsManyRoundingsAndHardlyMore) {
  const mpq_class above = 1 + mpq_class(kUnitRoundoff), below = 1 - mpq_class(kUnitRoundoff);
  for (const int n : {1, 2, 3, 7, 14, 16, 66, 512}) {
    const mpq_class error(detail::errorOf(n));
    EXPECT_LE(mpq_class(power(above, n) - 1), error) << n;
    EXPECT_LE(mpq_class(1 - power(below, n)), error) << n;
    EXPECT_GE(mpq_class((n + 1) * mpq_class(kUnitRoundoff)), error) << n;
  }
}

/// y is the largest number that n roundings may have made x from, or the smallest one.
template <int n, int... more>
void expectBounds(double x) {
  const mpq_class exact(x), unit(kUnitRoundoff);
  const mpq_class most = exact / power(1 - unit, n), least = exact / power(1 + unit, n);
  const double up = detail::roundedUp<n>(x), down = detail::roundedDown<n>(x);
  ASSERT_GE(mpq_class(up), most) << n << " " << x;
  ASSERT_LE(mpq_class(down), least) << n << " " << x;
  ASSERT_LE(mpq_class(up), mpq_class(exact * (1 + (n + 6) * unit))) << n << " " << x;
  ASSERT_GE(mpq_class(down), mpq_class(exact * (1 - (n + 4) * unit))) << n << " " << x;
  if constexpr (sizeof...(more) > 0) expectBounds<more...>(x);
}

TEST(Rounded, UpAndDownUndoTheWorst) {
  Random random(5);
  for (int i = 0; i < 3000; ++i) {
    // Where doubles are densest and sparsest relative to their size, and anywhere.
    const double kinds[] = {1, std::nextafter(1.0, 2.0), std::nextafter(2.0, 1.0), random.real(1, 2)};
    const double x = std::ldexp(kinds[random.integer(0, 3)], random.integer(-900, 900));
    expectBounds<0, 1, 2, 3, 4, 8, 16>(x);
  }
}

TEST(NormBelow, IsATightLowerBoundOrNone) {
  Random random(6);
  for (int i = 0; i < 20000; ++i) {
    const int exponent = random.coin() ? random.integer(-520, 520) : random.integer(-1060, 980);
    const double size = std::ldexp(random.real(1, 2), exponent);
    const double x = size * random.real(-1, 1), y = size * (random.oneIn(5) ? 0 : random.real(-1, 1));
    const mpq_class bound(detail::normBelow(x, y)), exact = mpq_class(x) * x + mpq_class(y) * y;
    ASSERT_LE(mpq_class(bound * bound), exact) << x << " " << y;
    if (size < 0x1p-470 || size > 0x1p510 || std::hypot(x, y) < 0x1p-470) continue;
    const mpq_class nearly = exact * (1 - 16 * mpq_class(kUnitRoundoff));
    ASSERT_GE(mpq_class(bound * bound), nearly) << x << " " << y;
  }
  // Squares that lose digits, and such that overflow.
  EXPECT_LE(detail::normBelow(1.7e-162, 0), 1.7e-162);  // its square rounds up to the smallest denormal
  for (const double x : {0x1p-500, 0x1p-1074, 0x1p600, HUGE_VAL, std::nan("")})
    EXPECT_EQ(detail::normBelow(x, x < 1 ? x : 1), 0) << x;
}

/// By their series up to x^29, whose rest is below 2^-100.
TEST(SineAndCosine, AreRightTo2U) {
  Random random(7);
  for (int i = 0; i < 3000; ++i) {
    const double x =
        i < 2 ? 2 * i - 1 : random.real(-1, 1) * (random.coin() ? 1 : std::ldexp(1, -random.integer(1, 40)));
    mpq_class sine(0), cosine(0), term(1);
    for (int k = 0; k < 30; term *= mpq_class(x) / ++k) (k % 2 == 0 ? cosine : sine) += k % 4 < 2 ? term : -term;
    const detail::Double2 found = detail::sineAndCosine(x);
    const mpq_class limit = 2 * mpq_class(kUnitRoundoff);
    ASSERT_LE(abs(mpq_class(found[0]) - sine), limit) << x;
    ASSERT_LE(abs(mpq_class(found[1]) - cosine), limit) << x;
  }
  EXPECT_EQ(detail::sineAndCosine(2.5)[0], std::sin(2.5));
  EXPECT_EQ(detail::sineAndCosine(-40)[1], std::cos(-40.0));
  EXPECT_TRUE(std::isnan(detail::sineAndCosine(std::numeric_limits<double>::quiet_NaN())[0]));
}

}  // namespace
}  // namespace tricover::support
