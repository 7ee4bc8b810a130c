// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "numbers/double2.h"
#include "tricover/motion.h"

namespace tricover::detail {

/// Vectors are in a pair's length (MovingPair): squares don't overflow, and what underflows is far below its error.
inline double lengthOf(double x) { return std::abs(x); }
inline double lengthOf(const Vec2& x) { return x.norm(); }
inline bool isNull(double x) { return x == 0; }
inline bool isNull(const Vec2& x) { return bitsOf(load2(x.data()) == 0.0) == 3; }

/// A cubic c_1 t + c_2 t^2 + c_3 t^3 over time 0 to 1: a number or a vector.
template <typename T>
struct Cubic {
  T first, second, third;

  bool isStraight() const { return isNull(second) && isNull(third); }
  bool isZero() const { return isNull(first) && isStraight(); }

  T at(double t) const { return ((third * t + second) * t + first) * t; }
  T rateAt(double t) const { return first + t * (2 * second + 3 * t * third); }
  T accelerationAt(double t) const { return 2 * second + 6 * t * third; }

  /// An upper bound, but for rounding, of |rate| over an interval: the rate is a quadratic, which leaves the line
  /// between its values at the ends by at most |3 c_3| h^2 / 4, h the interval's length.
  double mostRate(double begin, double end) const {
    if (isStraight()) return lengthOf(first);
    const double h = end - begin;
    return std::max(lengthOf(rateAt(begin)), lengthOf(rateAt(end))) + 0.75 * h * h * lengthOf(third);
  }
  /// The same of the acceleration, which is linear.
  double mostAcceleration(double begin, double end) const {
    if (isStraight()) return 0;
    return std::max(lengthOf(accelerationAt(begin)), lengthOf(accelerationAt(end)));
  }

  /// No part of it is longer, from time 0 to any other.
  double size() const { return lengthOf(first) + lengthOf(second) + lengthOf(third); }

  friend Cubic operator+(const Cubic& p, const Cubic& q) {
    return {p.first + q.first, p.second + q.second, p.third + q.third};
  }
  friend Cubic operator-(const Cubic& p, const Cubic& q) {
    return {p.first - q.first, p.second - q.second, p.third - q.third};
  }
  friend Cubic operator*(double factor, const Cubic& p) {
    return {factor * p.first, factor * p.second, factor * p.third};
  }
};

inline Cubic<Vec2> pathOf(const Motion& motion) { return {motion.shift, motion.shift_2, motion.shift_3}; }
inline Cubic<double> rotationOf(const Motion& motion) { return {motion.angle, motion.angle_2, motion.angle_3}; }

}  // namespace tricover::detail
