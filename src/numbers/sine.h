// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "numbers/double2.h"

namespace tricover::detail {

/// Sine and cosine, each right to 2U: by their series up to x^19 and x^18 for angles up to 1, side
/// by side; by the library's, which are right to an ulp, beyond that. In units of U, with z = x^2, |x| <= 1:
///   sin x = x + x h, h = z (s1 + z (s2 + ...)), |h| <= 1/6
///     h             s1, its sum, the product and z 1 of 1/6 each, the terms from s2 on 5 of 1/120    0.71
///     the product   1 of 1/6                                                                         0.17
///     the sum       1 of at most 0.85                                                                0.85
///     the rest      x^21 / 21!                                                                       0.01
///   cos x = 1 + h, h = z (c1 + z (c2 + ...)), |h| < 0.46, c1 = -1/2
///     h             what is below 1/2 rounds by 1/4: its sum and the product 1/2, z below 1 by 1/2,
///                   of which 0.46 counts; the terms from c2 on 5 of 1/24                             0.94
///     the sum       of at most 1                                                                     0.5
///     the rest      x^20 / 20!                                                                       0.01
inline Double2 sineAndCosine(double x) {
  if (!(std::abs(x) <= 1)) return Double2{std::sin(x), std::cos(x)};
  constexpr Double2 kTerms[] = {
      {-1 / 121645100408832000.0, -1 / 6402373705728000.0},
      {1 / 355687428096000.0, 1 / 20922789888000.0},
      {-1 / 1307674368000.0, -1 / 87178291200.0},
      {1 / 6227020800.0, 1 / 479001600.0},
      {-1 / 39916800.0, -1 / 3628800.0},
      {1 / 362880.0, 1 / 40320.0},
      {-1 / 5040.0, -1 / 720.0},
      {1 / 120.0, 1 / 24.0},
      {-1 / 6.0, -1 / 2.0},
  };
  const double z = x * x;
  Double2 h = kTerms[0];
  for (int k = 1; k < 9; ++k) h = h * z + kTerms[k];
  const Double2 leading{x, 1};
  return leading + leading * (h * z);
}

}  // namespace tricover::detail
