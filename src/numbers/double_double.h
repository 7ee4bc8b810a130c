// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "numbers/double2.h"
#include "numbers/rounding.h"

namespace tricover::detail {

/// An unevaluated sum of two numbers, doubles or Double2 (then lane by lane): what high rounds off is in low.
template <typename Real>
struct Twofold {
  Real high{}, low{};
};

/// p + q, exactly (Knuth), unless it overflows.
template <typename Real>
[[gnu::always_inline]] inline Twofold<Real> twoSum(Real p, Real q) {
  const Real sum = p + q, from_q = sum - p;
  return {sum, (p - (sum - from_q)) + (q - from_q)};
}

/// What is left of a product, exactly unless it is below 2^-1074: by one fused operation. Where the target has none,
/// std::fma is a call of libm, right all the same.
inline double productRest(double p, double q, double product) { return std::fma(p, q, -product); }

/// The same for two lanes. A call of libm for each would cost more than the whole product: where the target has no
/// fused operation, each factor is cut into halves of its digits, whose products are exact (Dekker, Veltkamp). Same
/// bits, for factors below 2^996.
inline Double2 productRest(Double2 p, Double2 q, Double2 product) {
#ifdef __FMA__
  return Double2{std::fma(p[0], q[0], -product[0]), std::fma(p[1], q[1], -product[1])};
#else
  const auto highHalf = [](Double2 x) {
    const Double2 large = 134217729.0 * x;  // 2^27 + 1
    return large - (large - x);
  };
  const Double2 ph = highHalf(p), pl = p - ph, qh = highHalf(q), ql = q - qh;
  return ((ph * qh - product) + ph * ql + pl * qh) + pl * ql;
#endif
}

/// p q, exactly but for underflow of the rest.
template <typename Real>
Twofold<Real> twoProduct(Real p, Real q) {
  const Real product = p * q;
  return {product, productRest(p, q, product)};
}

/// A number of twice the digits: low is at most half an ulp of high. Sums err by at most 3.1 U^2 of themselves,
/// products by at most 5.1 U^2, while nothing overflows and no product is below 2^-900 (Joldes, Muller and Popescu,
/// Tight and rigorous error bounds for basic building blocks of double-word arithmetic, 2017: AccurateDWPlusDW,
/// DWTimesDW1). Lane by lane for Double2.
template <typename Real>
Twofold<Real> operator-(const Twofold<Real>& x) {
  return {-x.high, -x.low};
}

template <typename Real>
Twofold<Real> operator+(const Twofold<Real>& x, const Twofold<Real>& y) {
  const Twofold<Real> high = twoSum(x.high, y.high), low = twoSum(x.low, y.low);
  const Twofold<Real> sum = twoSum(high.high, high.low + low.high);
  return twoSum(sum.high, sum.low + low.low);
}

template <typename Real>
Twofold<Real> operator-(const Twofold<Real>& x, const Twofold<Real>& y) {
  return x + -y;
}

template <typename Real>
Twofold<Real> operator*(const Twofold<Real>& x, const Twofold<Real>& y) {
  const Twofold<Real> product = twoProduct(x.high, y.high);
  return twoSum(product.high, product.low + (x.high * y.low + x.low * y.high));
}

using DoubleDouble = Twofold<double>;

}  // namespace tricover::detail
