// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "impact/time_interval.h"
#include "numbers/rounding.h"

namespace tricover::detail {

/// Cuts an interval down to where contact may lie, by one axis after the other.
class GapCutter {
 public:
  explicit GapCutter(const MovingPair& pair) : error_(pair.error), margin_(pair.margin) {}

  /// An axis over the interval, of length 1 at its begin.
  struct Axis {
    Double2 x, y;
    double chord_error;
  };
  static Axis standing(const Vec2& axis, double chord_error) {
    return {axis.x() - Double2{}, axis.y() - Double2{}, chord_error};
  }
  /// One that rotates with a frame of axes u and v.
  static Axis rotating(const Vec2& axis, Double2 ux, Double2 uy, Double2 vx, Double2 vy, double chord_error) {
    const double u = axis.x() * ux[0] + axis.y() * uy[0], v = axis.x() * vx[0] + axis.y() * vy[0];
    return {u * ux + v * vx, u * uy + v * vy, chord_error};
  }
  /// By the gap, at both ends of the interval, of all that may meet: computed, error and margin still in it. Whether it
  /// separates that throughout.
  bool cutByGap(const Axis& axis, Double2 gap);

  /// The part of the interval that no axis has cut off; low > high if nothing is left.
  Rest rest() const { return {first_.share(), 1 - last_.share(), first_.aim()}; }
  double restLow() const { return first_.share(); }

 protected:
  Double2 allowance(Double2 nx, Double2 ny) const;

  double error_, margin_;
  CutSide first_, last_;
};

/// The same of two boxes.
class IntervalCutter : public GapCutter {
 public:
  IntervalCutter(const TimeInterval& interval, const MovingBox& a, const MovingBox& b);

  /// An axis of length 1 at the interval's begin, which rotates with a, with b or not at all, as is best for points of
  /// them.
  Axis axisOver(const Vec2& axis) const;

  /// Each returns whether it separates the boxes throughout. By such an axis:
  bool cutByAxis(const Vec2& axis);
  /// By the axes of a or b, which turn with it or, if that loses more, stand still as in the middle of the interval.
  bool cutByAxesOfA() {
    return cutByAxesOf(a_, rotates_with_a_, rotates_with_a_ ? chord_error_with_a_ : chord_error_fixed_);
  }
  bool cutByAxesOfB() {
    return cutByAxesOf(b_, rotates_with_b_, rotates_with_b_ ? chord_error_with_b_ : chord_error_fixed_);
  }
  /// By the normals of two edges.
  bool cutByNormals() { return cut(a_.vx, a_.vy, chord_error_with_a_) || cut(b_.vx, b_.vy, chord_error_with_b_); }

  double chordErrorWithA() const { return chord_error_with_a_; }
  double chordErrorWithB() const { return chord_error_with_b_; }

  /// By how much points' paths across the interval may bend, along an axis that stands still.
  double bend() const { return 0.25 * chord_error_fixed_; }

 private:
  bool cutByAxesOf(const MovingBox& box, bool rotates, double chord_error);
  bool cut(Double2 nx, Double2 ny, double chord_error);

  const MovingBox &a_, &b_;
  const Pull& pull_;
  double chord_error_fixed_ = 0, chord_error_with_a_ = 0, chord_error_with_b_ = 0;
  bool rotates_with_a_ = false, rotates_with_b_ = false;
};

// The gap along an axis is the least of n . (p_b - p_a) over points of both boxes: see RotatingChordError.
inline IntervalCutter::IntervalCutter(const TimeInterval& interval, const MovingBox& a, const MovingBox& b)
    : GapCutter(interval.pair), a_(a), b_(b), pull_(interval.pull) {
  const Rates& rates = interval.rates;
  if (!rates.rotates()) {
    chord_error_fixed_ = chord_error_with_a_ = chord_error_with_b_ = interval.with_a.always;
    return;
  }
  const double lever_a = leverAtBegin(a, interval.a), lever_b = leverAtBegin(b, interval.b);
  chord_error_fixed_ = interval.fixedChordError(lever_a, lever_b);
  chord_error_with_a_ = interval.with_a.of(lever_b, leverAtBegin(b, interval.a));
  chord_error_with_b_ = interval.with_b.of(lever_a, leverAtBegin(a, interval.b));
  // A box that rotates while the axis stands still loses as much as its ends rise.
  const double twice = 2 * interval.length;
  rotates_with_a_ = chord_error_with_a_ < chord_error_fixed_ + twice * rates.a * (a.along + a.across);
  rotates_with_b_ = chord_error_with_b_ < chord_error_fixed_ + twice * rates.b * (b.along + b.across);
}

inline IntervalCutter::Axis IntervalCutter::axisOver(const Vec2& axis) const {
  const double chord_error_fixed = chord_error_fixed_ - pull_.sparedAlong(axis.x(), axis.y());
  if (chord_error_fixed <= std::min(chord_error_with_a_, chord_error_with_b_)) return standing(axis, chord_error_fixed);
  const bool with_a = chord_error_with_a_ <= chord_error_with_b_;
  const MovingBox& box = with_a ? a_ : b_;
  return rotating(axis, box.ux, box.uy, box.vx, box.vy, with_a ? chord_error_with_a_ : chord_error_with_b_);
}

inline bool IntervalCutter::cutByAxis(const Vec2& axis) {
  const Axis n = axisOver(axis);
  return cut(n.x, n.y, n.chord_error);
}

inline bool IntervalCutter::cutByAxesOf(const MovingBox& box, bool rotates, double chord_error) {
  if (rotates) return cut(box.ux, box.uy, chord_error) || cut(box.vx, box.vy, chord_error);
  const auto cutInTheMiddle = [&](Double2 x, Double2 y) {
    const Double2 nx = 0.5 * (x + swapped(x)), ny = 0.5 * (y + swapped(y));
    return cut(nx, ny, chord_error - pull_.sparedAlong(nx[0], ny[0]));
  };
  return cutInTheMiddle(box.ux, box.uy) || cutInTheMiddle(box.vx, box.vy);
}

/// Returns the length that a gap must exceed. Gaps are as much longer than distances as the axis, by a pose off rigid,
/// is than 1.
inline Double2 GapCutter::allowance(Double2 nx, Double2 ny) const {
  if (!(margin_ > 0)) return error_ - Double2{};
  const Double2 square = nx * nx + ny * ny;
  return margin_ * std::sqrt(std::max(square[0], square[1])) * (1 + 8 * kUnitRoundoff) + error_ - Double2{};
}

inline bool GapCutter::cutByGap(const Axis& axis, Double2 gap) {
  gap -= allowance(axis.x, axis.y);
  return first_.offer(gap[0], gap[1], axis.chord_error) || last_.offer(gap[1], gap[0], axis.chord_error);
}

inline bool IntervalCutter::cut(Double2 nx, Double2 ny, double chord_error) {
  Double2 distance = nx * (b_.x - a_.x) + ny * (b_.y - a_.y);
  if (distance[0] < 0) distance = -distance;
  Double2 reach = absolute(nx * a_.ux + ny * a_.uy) * a_.along + absolute(nx * a_.vx + ny * a_.vy) * a_.across +
                  absolute(nx * b_.ux + ny * b_.uy) * b_.along + absolute(nx * b_.vx + ny * b_.vy) * b_.across +
                  allowance(nx, ny);
  const Double2 gap = distance - reach;
  if (first_.offer(gap[0], gap[1], chord_error)) return true;
  return distance[1] < 0 ? last_.offer(-distance[1] - reach[1], -distance[0] - reach[0], chord_error)
                         : last_.offer(gap[1], gap[0], chord_error);
}

}  // namespace tricover::detail
