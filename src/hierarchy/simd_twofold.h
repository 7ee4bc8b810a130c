// SPDX-License-Identifier: BSD-3-Clause
// Ways and areas in two-fold numbers, two lanes each. Lanes::productRest(p, q, product) is double_double.h's: by one
// fused operation where the processor has it, which takes a quarter of the time of what stands for it.
#pragma once

#include "hierarchy/simd.h"

namespace tricover::detail::simd {

using Twofold2 = Twofold<Double2>;

[[gnu::always_inline]] inline Double2 inBoth(double x) { return x - Double2{}; }

template <class Lanes>
[[gnu::always_inline]] inline Twofold2 product(Double2 p, Double2 q) {
  const Double2 high = p * q;
  return {high, Lanes::productRest(p, q, high)};
}

// Vectors go from a to b whatever the edge is of, so that two vertices are found just as far apart from either's edges.
// Each of the four products and four sums is at most M, the size, and rounds by U M, which is kept in the low parts, as
// is what t was rounded by; their own eight sums round by U of at most 9U M.
template <class Lanes>
void twofoldWay(const double* pose_a, Double2 p, const double* pose_b, Double2 q, double scale, Twofold2& way) {
  p = p * scale;
  q = q * scale;
  // Translations may be large where their difference is small.
  const double first = scale < 1 ? scale : 1, then = scale < 1 ? 1 : scale;
  const Twofold2 unscaled = twoSum(load2(pose_b + 6) * first, load2(pose_a + 6) * -first),
                 shift = {unscaled.high * then, unscaled.low * then};
  const Twofold2 b0 = product<Lanes>(load2(pose_b), inBoth(q[0])), b1 = product<Lanes>(load2(pose_b + 3), inBoth(q[1]));
  const Twofold2 a0 = product<Lanes>(load2(pose_a), inBoth(p[0])), a1 = product<Lanes>(load2(pose_a + 3), inBoth(p[1]));
  const Twofold2 of_b = twoSum(b0.high, b1.high), of_a = twoSum(a0.high, a1.high);
  const Twofold2 of_both = twoSum(of_b.high, -of_a.high), w = twoSum(shift.high, of_both.high);
  const Double2 rests = (b0.low + b1.low) - (a0.low + a1.low), sums = (of_b.low - of_a.low) + (of_both.low + w.low);
  way = twoSum(w.high, rests + (sums + shift.low));
}

template <class Lanes>
double twofoldArea(const double* pose, Double2 p, Double2 q, const Twofold2& way, Double2& along) {
  const Double2 column_0 = load2(pose), column_1 = load2(pose + 3);
  const Twofold2 difference = twoSum(q, -p);
  const Twofold2 first = product<Lanes>(column_0, inBoth(difference.high[0]));
  const Twofold2 second = product<Lanes>(column_1, inBoth(difference.high[1])), sum = twoSum(first.high, second.high);
  const Double2 rest_of_u = column_0 * difference.low[0] + column_1 * difference.low[1];
  const Twofold2 u = twoSum(sum.high, sum.low + (first.low + second.low + rest_of_u));
  along = u.high;
  const Twofold2 products = product<Lanes>(u.high, swapped(way.high));
  const Double2 rest = products.low + (u.high * swapped(way.low) + u.low * swapped(way.high));
  const Twofold2 area = twoSum(inBoth(products.high[0]), inBoth(-products.high[1]));
  return area.high[0] + (area.low[0] + (rest[0] - rest[1]));
}

}  // namespace tricover::detail::simd
