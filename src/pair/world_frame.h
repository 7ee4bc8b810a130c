// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "numbers/segment.h"
#include "pair/posed_pair.h"

namespace tricover::detail {

/// The world seen from b's origin S, in b's units (larger ones where b is less than 2^-200 of a, or 2^-404 of the way
/// to it), rounded: for what an answer reports, not for what it is. Nothing overflows here, and b's coordinates are as
/// precise as b is small.
class WorldFrame {
 public:
  explicit WorldFrame(const PosedPair& pair);

  Vec2 fromA(const Vec2& local) const { return turned(0, pair_.a.inUnits(local)) + origin_a_; }
  Vec2 fromB(const Vec2& local) const { return turned(1, pair_.b.inUnits(local)); }
  Vec2 edgeOfA(EdgePosition position, double t) const { return between(edgeEndsOfA(position), t); }
  Vec2 edgeOfB(EdgePosition position, double t) const { return between(edgeEndsOfB(position), t); }

  using Ends = detail::Ends;
  Ends edgeEndsOfA(EdgePosition i) const { return {fromA(pair_.a.path[i]), fromA(pair_.a.path[i + 1])}; }
  Ends edgeEndsOfB(EdgePosition j) const { return {fromB(pair_.b.path[j]), fromB(pair_.b.path[j + 1])}; }

  /// The same by side: 0 is a, 1 is b.
  Vec2 from(int side, const Vec2& local) const { return side == 0 ? fromA(local) : fromB(local); }
  Ends edgeEnds(int side, EdgePosition position) const {
    return side == 0 ? edgeEndsOfA(position) : edgeEndsOfB(position);
  }

  /// A vector in the polygon's units.
  Vec2 turned(int side, const Vec2& in_units) const {
    return side == 0 ? Vec2(linear_a_ * (in_units * scale_a_)) : Vec2(linear_b_ * (in_units * scale_b_));
  }
  /// A polygon's unit in the frame's, and whether its pose mirrors.
  double scale(int side) const { return side == 0 ? scale_a_ : scale_b_; }
  bool mirrors(int side) const { return (side == 0 ? linear_a_ : linear_b_).determinant() < 0; }

  /// Back into a polygon's own frame.
  Vec2 toA(const Vec2& p) const { return pair_.a.origin + linear_a_.inverse() * ((p - origin_a_) * unit_); }
  Vec2 toB(const Vec2& p) const { return pair_.b.origin + linear_b_.inverse() * (p * unit_); }
  /// Infinite where it is beyond the largest double, and only there.
  Vec2 toWorld(const Vec2& p) const { return (quarter_origin_ + p * (unit_ / 4)) * 4; }
  Vec2 fromWorld(const Vec2& p) const { return (p / 4 - quarter_origin_) / unit_ * 4; }

  double unit() const { return unit_; }
  const Vec2& originOfA() const { return origin_a_; }  ///< b's is zero

  /// How far a mapped point of an edge may be from the true one. In either coordinate, of lengths r <= 1 unit and the
  /// shift o between the origins, in units of U:
  ///   a vertex      to units 1, products 1, sum 1, with the shift 1: 4 r + o; the shift itself 1
  ///   t (w - v)     difference and product, of at most r: 2 r; the sum with an end 1 (r + o)
  /// which is 7 r + 3 o; sqrt2 of it in any direction.
  double error() const { return error_; }
  static constexpr double kPointError = 16 * kUnitRoundoff;
  static_assert(kPointError >= kUnitRows * kRoot2 * errorOf(7) * (1 + errorOf(3)));
  /// At least what is between the frame's origin and any vertex, in either coordinate, but for kLargestDefect.
  double size() const { return error_ / kPointError; }

 private:
  static Vec2 between(const Ends& ends, double t) {
    return t < 0.5 ? Vec2(ends.v + t * (ends.w - ends.v)) : Vec2(ends.w + (t - 1) * (ends.w - ends.v));
  }

  const PosedPair& pair_;
  Eigen::Matrix2d linear_a_, linear_b_;
  Vec2 quarter_to_a_;  ///< of the way from b's S to a's in the world
  double unit_, scale_a_, scale_b_, error_;
  Vec2 origin_a_;
  Vec2 quarter_origin_;  ///< of b's S in the world
};

}  // namespace tricover::detail
