// SPDX-License-Identifier: BSD-3-Clause
// Boxes along the axes, and what is asked of eight at a time.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "hierarchy/simd_function.h"
#include "numbers/double2.h"
#include "numbers/rounding.h"
#include "tricover/pose.h"

namespace tricover::detail {

/// A box along the axes: the world's, if nothing else is said.
struct Bounds {
  double min_x, min_y, max_x, max_y;

  static Bounds between(Double2 low, Double2 high) { return {low[0], low[1], high[0], high[1]}; }
  Double2 low() const { return load2(&min_x); }
  Double2 high() const { return load2(&max_x); }

  bool meets(const Bounds& other) const { return (bitsOf(low() <= other.high()) & bitsOf(other.low() <= high())) == 3; }
  bool contains(const Bounds& other) const {
    return (bitsOf(low() <= other.low()) & bitsOf(other.high() <= high())) == 3;
  }
  Bounds grown(double length) const { return between(low() - length, high() + length); }
};

inline Bounds unite(const Bounds& p, const Bounds& q) {
  return Bounds::between(smaller(q.low(), p.low()), larger(q.high(), p.high()));
}

/// Eight of them side by side.
struct alignas(64) EightBoxes {
  double min_x[kLanes], min_y[kLanes], max_x[kLanes], max_y[kLanes];

  Bounds at(unsigned i) const { return {min_x[i], min_y[i], max_x[i], max_y[i]}; }
  void set(unsigned i, const Bounds& bounds) {
    min_x[i] = bounds.min_x, min_y[i] = bounds.min_y, max_x[i] = bounds.max_x, max_y[i] = bounds.max_y;
  }
};

/// A ray as boxes are asked about it. It passes the coordinate x of an axis at the fraction x * inverse - c, with c =
/// from * inverse: boxes are entered after x * inverse - enter and left before x * inverse - leave.
///
/// Error. Beside 6U of a fraction, which kEarlier pays for where that is at most 1: 4U |c|, because x * inverse rounds
/// by U of itself, and that is at most 2 |c| or half of it is left. Along an axis where the way is shorter than `least`
/// it is taken for that: the ray stays within 1 in these fractions of where it begins, and sides are moved by 2. Those
/// of grown boxes are moved by the margin, too. A way that overflows tells nothing.
struct BoxRay {
  static constexpr double kEarlier = 4e-13;

  /// For boxes that are to be grown by `margin`.
  BoxRay(const Vec2& from, const Vec2& to, double margin = 0) {
    for (const int axis : {0, 1}) {
      const double way = to[axis] - from[axis], least = std::max(1e-290, 0x1p-60 * std::abs(from[axis]));
      const bool known = std::isfinite(way);
      inverse[axis] = std::copysign(known ? 1 / std::max(std::abs(way), least) : 1e-307, way);
      const double c = from[axis] * inverse[axis], grown = margin * std::abs(inverse[axis]);
      const double room = 8 * kUnitRoundoff * (std::abs(c) + grown) + grown + kEarlier;
      const double slack = !known ? std::numeric_limits<double>::infinity() : std::abs(way) < least ? room + 2 : room;
      enter[axis] = c + slack;
      leave[axis] = c - slack;
    }
  }

  double inverse[2], enter[2], leave[2];
};

/// Bit per box that meets another one. Boxes of NaN meet nothing, here and below.
extern Simd<unsigned(const EightBoxes& boxes, const Bounds& bounds)> boxesMeeting;
/// Bit per box that a ray enters before the fraction `most`, and lower bounds of all these fractions.
extern Simd<unsigned(const EightBoxes& boxes, const BoxRay& ray, double most, double* at)> boxesOnRay;
/// Bit per box whose gap from `bounds`, squared and rounded, is at most `most`, and all these squares.
extern Simd<unsigned(const EightBoxes& boxes, const Bounds& bounds, double most, double* at)> boxesNear;
/// No square of boxesNear() is above this where the gap is at most `gap`: a difference, twice, its square and the
/// sum are rounded, and the square and the sum here. Where those overflow, every gap is near; underflow loses kTiny at
/// the most.
inline double gapSquareAbove(double gap) { return roundedUp<2 + 1 + 1 + 1 + 1>(gap * gap) + kTiny; }

}  // namespace tricover::detail
