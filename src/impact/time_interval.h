// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "impact/moving_pair.h"
#include "numbers/rigidity.h"

namespace tricover::detail {

/// See RotatingChordError.
constexpr double kChordErrorGrowth = 1 + 0x1p-10;
static_assert(kChordErrorGrowth > (1 + 2 * kLargestDefect) * (1 + 2 * kLargestDefect));

/// An upper bound of a length, too large by 8 percent at most.
inline double lengthAbove(double x, double y) {
  x = std::abs(x);
  y = std::abs(y);
  return std::max(x, y) + 0.41422 * std::min(x, y);
}

/// How far a box reaches from a mover's pivot, at the interval's begin.
inline double leverAtBegin(const MovingBox& box, const Places& places) {
  return lengthAbove(box.x[0] - places.pivot_x[0], box.y[0] - places.pivot_y[0]) + box.along + box.across;
}

/// The share [low, high] of an interval that contact may lie in.
struct Rest {
  double low, high;
  double aim;  ///< where points that aren't accelerated would meet along the axis that `low` is due to
};

/// Seen from one end of an interval, a gap is at least from - slope x + chord_error x^2 after a share x of it: it stays
/// positive for a share of about from / slope. This is the one that does so longest.
struct CutSide {
  double from = 0, to = 0, slope = 1, chord_error = 0;

  /// Another gap, which is `to_` at the other end. Whether that stays positive throughout.
  bool offer(double from_, double to_, double chord_error_) {
    if (!(from_ > 0)) return false;
    const double slope_ = from_ - to_ + chord_error_;
    if (slope_ < from_ || slope_ * slope_ < 4 * chord_error_ * from_) return true;  // without a root in [0, 1]
    // Division can wait until the best is known; as can the root, of which this is the first order.
    if (from_ * slope > from * slope_) *this = {from_, to_, slope_, chord_error_};
    return false;
  }

  double share() const {
    if (from == 0) return 0;
    const double root = std::sqrt(std::max(slope * slope - 4 * chord_error * from, 0.0));
    return std::min(2 * from / (slope + root), 1.0);
  }
  /// Contact is likely there. Where paths bend by as much as the gap closes, a straight line tells little. The aim is
  /// then no nearer than where they bend by a share of the gap: a gap that is least in the interval is passed in few
  /// steps.
  double aim() const {
    constexpr double kDoubt = 0x1p-3, kBent = 0.375;
    const double straight = from / (from - to);
    return chord_error > kDoubt * (from - to) ? std::max(straight, kBent * std::sqrt(from / chord_error)) : straight;
  }
};

// How far paths bend in an interval. Say that along an axis no distance n . (p_b - p_a) of two points, as a function of
// time, has a second derivative beyond A. Then after a share x of the interval, of length h, each is at least what is
// interpolated between its values at both ends, minus A h^2 x (1 - x) / 2; and so is the gap of the two polygons, the
// least of them. `chord_error` is A h^2 / 2.
//
// With r_a, r_b the points' levers from their pivots, which rotate at rates alpha and beta, D the vector from a's pivot
// to b's, V its velocity and W its acceleration, a dash for derivatives in time: along a fixed axis of length 1,
//   A <= (alpha^2 + |alpha'|) |r_a| + (beta^2 + |beta'|) |r_b| + |W|.
// In a frame around a's pivot that rotates with a at the rate alpha, where r_a stands still, the acceleration of p_b
// is, with J the quarter turn,
//   W - 2 alpha J V - (alpha' J + alpha^2) D + ((beta' - alpha') J - (beta - alpha)^2) r_b.
// Along an axis that rotates with a, that makes
//   A <= (|beta' - alpha'| + (beta - alpha)^2) |r_b| + (|alpha'| + alpha^2) |D| + 2 |alpha| |V| + |W|,
// or, by D = (p_b - c_a) - r_b for a's pivot c_a, with the first two terms replaced by
//   (|beta'| + |beta| |beta - 2 alpha|) |r_b| + (|alpha'| + alpha^2) |p_b - c_a|;
// and likewise for an axis that rotates with b. |D| and |p_b - c_a| are bounded over the interval by their value at its
// begin and how fast they change. Where the axis n stands still, |W| is |n . W|. kChordErrorGrowth pays for rounding,
// for axes that a pose off rigid makes longer than 1, and for extents that it stretches.

/// The chord error along axes that rotate with one polygon, of points of the other one: the smaller of two bounds, both
/// linear.
struct RotatingChordError {
  double always, by_lever;
  double other_always, other_by_lever, by_distance;

  /// Returns the bound for points no farther from their own pivot than `lever`, and from the other one, at the
  /// interval's begin, than `distance`.
  double of(double lever, double distance) const {
    return std::min(always + by_lever * lever, other_always + other_by_lever * lever + by_distance * distance);
  }
};

/// What W makes of the chord error: along any axis at most so much, and its values at both ends of the interval,
/// between which it is linear, as W is of a cubic path.
struct Pull {
  double most = 0;
  Double2 x, y;  ///< unless the most is 0

  /// By how much less the chord error is along an axis of length 1 that stands still. Rounding is below 16U of the
  /// most: 4U of x and y, as much once they are mapped into a frame, 3U of their product with an axis that is wrong by
  /// 3U itself.
  double sparedAlong(double nx, double ny) const {
    if (most == 0) return 0;
    const Double2 along = absolute(nx * x + ny * y);
    return std::max(most * (1 - 16 * kUnitRoundoff) - std::max(along[0], along[1]), 0.0);
  }
};

/// An interval of time with both movers' places at its ends.
struct TimeInterval {
  TimeInterval(const TimeInterval&) = delete;
  TimeInterval(const MovingPair& pair_, double begin_, double end_)
      : TimeInterval(pair_, begin_, end_, pair_.a.places(begin_, end_), pair_.b.places(begin_, end_)) {}
  TimeInterval(const MovingPair& pair_, double begin_, double end_, const Places& a_, const Places& b_)
      : pair(pair_),
        begin(begin_),
        end(end_),
        length(end - begin),
        half_square(0.5 * kChordErrorGrowth * length * length),
        rates(pair.is_steady ? pair.steady : (own_rates = pair.ratesOf(begin, end))),
        a(a_),
        b(b_),
        pull(pullOf()),
        with_a(rotatingChordError(rates.a, rates.bend_a, rates.b, rates.mixed_b)),
        with_b(rotatingChordError(rates.b, rates.bend_b, rates.a, rates.mixed_a)) {}

  /// Along axes that stand still.
  double fixedChordError(double lever_a, double lever_b) const {
    return half_square * rates.bend(lever_a, lever_b) + pull.most;
  }

  const MovingPair& pair;
  double begin, end;
  double length, half_square;  ///< h; h^2 / 2, rounded upwards
  Rates own_rates;             ///< where the pair's aren't steady
  const Rates& rates;
  Places a, b;
  Pull pull;
  const RotatingChordError with_a, with_b;  ///< along axes that rotate with a, or with b

 private:
  Pull pullOf() const {
    if (!(rates.pull > 0)) return {0, Double2{}, Double2{}};
    const Vec2 from = pair.b.path.accelerationAt(begin), to = pair.b.path.accelerationAt(end);
    return {half_square * rates.pull, half_square * Double2{from.x(), to.x()}, half_square * Double2{from.y(), to.y()}};
  }
  /// `rate` and `bend` are those of the polygon that the axes rotate with, `own` and `mixed` the other one's.
  RotatingChordError rotatingChordError(double rate, double bend, double own, double mixed) const {
    if (!rates.rotates()) return {pull.most, 0, pull.most, 0, 0};
    const double apart = lengthAbove(b.pivot_x[0] - a.pivot_x[0], b.pivot_y[0] - a.pivot_y[0]) + length * rates.speed;
    const double always = 2 * rate * rates.speed + rates.pull;
    return {half_square * (always + bend * apart), half_square * rates.relative_bend,
            half_square * (always + bend * length * rates.speed), half_square * (mixed + bend * length * own),
            half_square * bend};
  }
};

}  // namespace tricover::detail
