// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "impact/moving_pair.h"
#include "numbers/rounding.h"

namespace tricover::detail {

/// The share [low, high] of a window that contact may lie in.
struct Rest {
  double low, high;
  double aim;  ///< where points that aren't accelerated would meet along the axis that `low` is due to
};

/// Seen from one end of a window, a gap is at least from - slope x + sag x^2 after a share x of it: it stays positive
/// for a share of about from / slope. This is the one that does so longest.
struct CutSide {
  double from = 0, to = 0, slope = 1, sag = 0;

  /// Another gap, which is `to_` at the other end. Whether that stays positive throughout.
  bool offer(double from_, double to_, double sag_) {
    if (!(from_ > 0)) return false;
    const double slope_ = from_ - to_ + sag_;
    if (slope_ < from_ || slope_ * slope_ < 4 * sag_ * from_) return true;  // without a root in [0, 1]
    // Division can wait until the best is known; as can the root, of which this is the first order.
    if (from_ * slope > from * slope_) *this = {from_, to_, slope_, sag_};
    return false;
  }

  double share() const {
    if (from == 0) return 0;
    const double root = std::sqrt(std::max(slope * slope - 4 * sag * from, 0.0));
    return std::min(2 * from / (slope + root), 1.0);
  }
  double aim() const { return from / (from - to); }
};

/// A window of time with both movers' places at its ends.
struct Window {
  Window(const Window&) = delete;
  Window(const MovingPair& pair_, double begin, double end)
      : pair(pair_),
        length(end - begin),
        rates(pair.is_steady ? pair.steady : (own_rates = pair.ratesOf(begin, end))),
        a(pair.a.places(begin, end)),
        b(pair.b.places(begin, end)) {}
  /// The places at the begin are known, in either lane.
  Window(const MovingPair& pair_, double begin, double end, const Places& a_at_begin, const Places& b_at_begin)
      : pair(pair_),
        length(end - begin),
        rates(pair.is_steady ? pair.steady : (own_rates = pair.ratesOf(begin, end))),
        a(a_at_begin.to(pair.a.places(end, end))),
        b(b_at_begin.to(pair.b.places(end, end))) {}

  const MovingPair& pair;
  double length;
  Rates own_rates;  ///< where the pair's aren't steady
  const Rates& rates;
  Places a, b;
};

/// Cuts a window down to where contact of two boxes may lie, by one axis after the other.
class WindowCutter {
 public:
  WindowCutter(const Window& window, const MovingBox& a, const MovingBox& b);

  /// Each returns whether it parts the boxes throughout. By an axis of length 1 at the window's begin, which turns with
  /// a, with b or not at all, as is best:
  bool cutByAxis(const Vec2& axis);
  /// By the axes of a or b, which turn with it or, if that loses more, stand still as in the middle of the window.
  bool cutByAxesOfA() { return cutByAxesOf(a_, turns_with_a_, turns_with_a_ ? sag_with_a_ : sag_fixed_); }
  bool cutByAxesOfB() { return cutByAxesOf(b_, turns_with_b_, turns_with_b_ ? sag_with_b_ : sag_fixed_); }
  /// By the normals of two edges.
  bool cutByNormals() { return cut(a_.vx, a_.vy, sag_with_a_) || cut(b_.vx, b_.vy, sag_with_b_); }

  /// An axis over the window, turning as cutByAxis() has it.
  struct Axis {
    Double2 x, y;
    double sag;
  };
  Axis turning(const Vec2& axis) const;
  /// By the gap, at both ends of the window, of anything within the boxes: computed, error and margin still in it.
  bool cutByGap(const Axis& axis, Double2 gap);

  /// What no axis has cut off; nothing, low > high, is possible, too.
  Rest rest() const { return {first_.share(), 1 - last_.share(), first_.aim()}; }

  double sagWithA() const { return sag_with_a_; }
  double sagWithB() const { return sag_with_b_; }

  /// What points' ways across the window may bend by, seen along an axis that stands still.
  double bend() const { return 0.25 * sag_fixed_; }

 private:
  bool cutByAxesOf(const MovingBox& box, bool turns, double sag);
  bool cut(Double2 nx, Double2 ny, double sag);
  Double2 allowance(Double2 nx, Double2 ny) const;

  const MovingBox &a_, &b_;
  double error_, margin_;
  double sag_fixed_ = 0, sag_with_a_ = 0, sag_with_b_ = 0;
  bool turns_with_a_ = false, turns_with_b_ = false;
  CutSide first_, last_;
};

/// An upper bound of a length, too large by 8 percent at most.
inline double lengthAbove(double x, double y) {
  x = std::abs(x);
  y = std::abs(y);
  return std::max(x, y) + 0.41422 * std::min(x, y);
}

// The gap along an axis is the least of n . (p_b - p_a) over points of both boxes. If no such function of time has a
// second derivative beyond A, each is at least its linear interpolation over the window minus A h^2 x (1 - x) / 2, with
// h the window's length and x the share of it that has passed; and so the least is at least the interpolation of the
// gaps at both ends minus the same. `sag` is A h^2 / 2.
//
// With r_a, r_b the points' levers from their pivots, which turn at rates alpha and beta, D the vector from a's pivot
// to b's, V its velocity and W its acceleration, a dash for derivatives in time: along a fixed axis of length 1,
//   A <= (alpha^2 + |alpha'|) |r_a| + (beta^2 + |beta'|) |r_b| + |W|.
// In a frame around a's pivot that turns with a at the rate alpha, where r_a stands still, the acceleration of p_b is,
// with J the quarter turn,
//   W - 2 alpha J V - (alpha' J + alpha^2) D + ((beta' - alpha') J - (beta - alpha)^2) r_b.
// So along an axis that turns with a,
//   A <= (|beta' - alpha'| + (beta - alpha)^2) |r_b| + (|alpha'| + alpha^2) |D| + 2 |alpha| |V| + |W|,
// or, by D = (p_b - c_a) - r_b for a's pivot c_a, with the first two terms replaced by
//   (|beta'| + |beta| |beta - 2 alpha|) |r_b| + (|alpha'| + alpha^2) |p_b - c_a|;
// and likewise for an axis that turns with b. |D| and |p_b - c_a| are bounded over the window by their value at its
// begin and how fast they change. 2^-10 pays for rounding, for axes that a pose off rigid by 1e-6 makes longer than 1,
// and for extents that it stretches.
inline WindowCutter::WindowCutter(const Window& window, const MovingBox& a, const MovingBox& b)
    : a_(a), b_(b), error_(window.pair.error), margin_(window.pair.margin) {
  const Rates& rates = window.rates;
  const double speed = rates.speed, h = window.length, half_square = 0.5 * (1 + 0x1p-10) * h * h;
  if (!rates.turns()) {
    sag_fixed_ = sag_with_a_ = sag_with_b_ = half_square * rates.pull;
    return;
  }
  const double alpha = rates.a, beta = rates.b;
  const Places &at_a = window.a, &at_b = window.b;
  const double extent_a = a.along + a.across, extent_b = b.along + b.across;
  const double lever_a = lengthAbove(a.x[0] - at_a.pivot_x[0], a.y[0] - at_a.pivot_y[0]) + extent_a;
  const double lever_b = lengthAbove(b.x[0] - at_b.pivot_x[0], b.y[0] - at_b.pivot_y[0]) + extent_b;
  const double apart = lengthAbove(at_b.pivot_x[0] - at_a.pivot_x[0], at_b.pivot_y[0] - at_a.pivot_y[0]) + h * speed;
  const double b_from_a =
      lengthAbove(b.x[0] - at_a.pivot_x[0], b.y[0] - at_a.pivot_y[0]) + extent_b + h * (speed + beta * lever_b);
  const double a_from_b =
      lengthAbove(a.x[0] - at_b.pivot_x[0], a.y[0] - at_b.pivot_y[0]) + extent_a + h * (speed + alpha * lever_a);
  const double of_a = rates.bend_a, of_b = rates.bend_b;
  const double with_a =
      std::min(rates.relative_bend * lever_b + of_a * apart, rates.mixed_b * lever_b + of_a * b_from_a);
  const double with_b =
      std::min(rates.relative_bend * lever_a + of_b * apart, rates.mixed_a * lever_a + of_b * a_from_b);
  sag_fixed_ = half_square * (of_a * lever_a + of_b * lever_b + rates.pull);
  sag_with_a_ = half_square * (with_a + 2 * alpha * speed + rates.pull);
  sag_with_b_ = half_square * (with_b + 2 * beta * speed + rates.pull);
  // A box that turns while the axis stands still loses as much as its ends rise.
  turns_with_a_ = sag_with_a_ < sag_fixed_ + 2 * alpha * h * extent_a;
  turns_with_b_ = sag_with_b_ < sag_fixed_ + 2 * beta * h * extent_b;
}

inline WindowCutter::Axis WindowCutter::turning(const Vec2& axis) const {
  if (sag_fixed_ <= std::min(sag_with_a_, sag_with_b_)) return {axis.x() - Double2{}, axis.y() - Double2{}, sag_fixed_};
  const bool with_a = sag_with_a_ <= sag_with_b_;
  const MovingBox& box = with_a ? a_ : b_;
  const double u = axis.x() * box.ux[0] + axis.y() * box.uy[0], v = axis.x() * box.vx[0] + axis.y() * box.vy[0];
  return {u * box.ux + v * box.vx, u * box.uy + v * box.vy, with_a ? sag_with_a_ : sag_with_b_};
}

inline bool WindowCutter::cutByAxis(const Vec2& axis) {
  const Axis n = turning(axis);
  return cut(n.x, n.y, n.sag);
}

inline bool WindowCutter::cutByAxesOf(const MovingBox& box, bool turns, double sag) {
  if (turns) return cut(box.ux, box.uy, sag) || cut(box.vx, box.vy, sag);
  const auto middle = [](Double2 p) { return 0.5 * (p + swapped(p)); };
  return cut(middle(box.ux), middle(box.uy), sag) || cut(middle(box.vx), middle(box.vy), sag);
}

/// What a gap must exceed. Gaps are as much longer than distances as the axis, by a pose off rigid, is than 1.
inline Double2 WindowCutter::allowance(Double2 nx, Double2 ny) const {
  if (!(margin_ > 0)) return error_ - Double2{};
  const Double2 square = nx * nx + ny * ny;
  return margin_ * std::sqrt(std::max(square[0], square[1])) * (1 + 8 * kUnitRoundoff) + error_ - Double2{};
}

inline bool WindowCutter::cutByGap(const Axis& axis, Double2 gap) {
  gap -= allowance(axis.x, axis.y);
  return first_.offer(gap[0], gap[1], axis.sag) || last_.offer(gap[1], gap[0], axis.sag);
}

inline bool WindowCutter::cut(Double2 nx, Double2 ny, double sag) {
  Double2 distance = nx * (b_.x - a_.x) + ny * (b_.y - a_.y);
  if (distance[0] < 0) distance = -distance;
  Double2 reach = absolute(nx * a_.ux + ny * a_.uy) * a_.along + absolute(nx * a_.vx + ny * a_.vy) * a_.across +
                  absolute(nx * b_.ux + ny * b_.uy) * b_.along + absolute(nx * b_.vx + ny * b_.vy) * b_.across +
                  allowance(nx, ny);
  const Double2 gap = distance - reach;
  if (first_.offer(gap[0], gap[1], sag)) return true;
  return distance[1] < 0 ? last_.offer(-distance[1] - reach[1], -distance[0] - reach[0], sag)
                         : last_.offer(gap[1], gap[0], sag);
}

}  // namespace tricover::detail
