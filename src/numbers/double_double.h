// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace tricover::detail {

/// An unevaluated sum of two doubles, the second at most half an ulp of the first. Sums and products err by less than
/// 2^-100 of the operands' magnitudes, while nothing overflows and no product is below 2^-900.
struct DoubleDouble {
  double high = 0, low = 0;
};

inline DoubleDouble exactSum(double x, double y) {
  const double sum = x + y, from_y = sum - x;
  return {sum, (x - (sum - from_y)) + (y - from_y)};
}

inline DoubleDouble exactProduct(double x, double y) {
  const double product = x * y;
  return {product, std::fma(x, y, -product)};
}

inline DoubleDouble operator-(const DoubleDouble& x) { return {-x.high, -x.low}; }

inline DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
  const DoubleDouble high = exactSum(x.high, y.high), low = exactSum(x.low, y.low);
  const DoubleDouble sum = exactSum(high.high, high.low + low.high);
  return exactSum(sum.high, sum.low + low.low);
}

inline DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) { return x + -y; }

inline DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
  const DoubleDouble product = exactProduct(x.high, y.high);
  return exactSum(product.high, product.low + (x.high * y.low + x.low * y.high));
}

struct DoubleDouble2 {
  DoubleDouble x, y;
};

inline DoubleDouble2 operator-(const DoubleDouble2& p, const DoubleDouble2& q) { return {p.x - q.x, p.y - q.y}; }
inline DoubleDouble dot(const DoubleDouble2& p, const DoubleDouble2& q) { return p.x * q.x + p.y * q.y; }

}  // namespace tricover::detail
