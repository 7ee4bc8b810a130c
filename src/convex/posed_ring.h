// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "convex/convex_ring.h"
#include "numbers/double2.h"
#include "numbers/rigidity.h"
#include "tricover/pose.h"

namespace tricover::detail {

/// A convex ring in the world, seen from `shift` before its pose's translation: p -> R p + shift.
class PosedRing {
 public:
  PosedRing(const ConvexRing& ring_, const Pose& pose, Double2 shift_ = Double2{})
      : PosedRing(ring_, load2(pose.data()), load2(pose.data() + 3), shift_) {}
  PosedRing(const ConvexRing& ring_, Double2 column_x_, Double2 column_y_, Double2 shift_)
      : ring(ring_),
        column_x(column_x_),
        column_y(column_y_),
        shift(shift_),
        mirrors_(cross(column_x_, column_y_) < 0) {}

  Double2 corner(std::uint32_t k) const { return turned(ring.vertex(k)) + shift; }
  Double2 way(std::uint32_t from, std::uint32_t to) const { return turned(ring.way(from, to)); }
  /// From corner k to the next one: the direction is as precise as the ring's, however short the edge is.
  Double2 edge(std::uint32_t k) const { return turned(ring.edge(k)); }

  /// Whether the pose mirrors.
  bool mirrors() const { return mirrors_; }
  /// Whether positions increase that way around.
  bool isForward(bool ccw) const { return ccw == ((ring.turn() > 0) != mirrors()); }
  std::uint32_t next(std::uint32_t k, bool ccw) const { return isForward(ccw) ? ring.next(k) : ring.previous(k); }
  /// Outwards from an edge, as long as that.
  Double2 normal(std::uint32_t k) const {
    const Double2 along = edge(k);
    return isForward(true) ? Double2{along[1], -along[0]} : Double2{-along[1], along[0]};
  }

  /// A point in the frame of the ring: off by at most kTurnedBackError of |p - shift|_1.
  Double2 inOwnFrame(Double2 p) const { return turnedBack(column_x, column_y, p - shift); }
  /// The direction in the ring's frame along which heights of its vertices are those of the corners along n.
  Double2 inFrame(Double2 n) const { return Double2{dot(column_x, n), dot(column_y, n)}; }
  /// The support vertex along n, as ConvexRing finds it.
  std::uint32_t supportVertex(Double2 n) const { return ring.supportVertex(inFrame(n)); }

  /// The same ring in a frame whose upward axis is the unit vector `up`.
  PosedRing turnedUp(Double2 up) const {
    const auto turn = [&](Double2 v) { return Double2{-cross(up, v), dot(up, v)}; };
    return {ring, turn(column_x), turn(column_y), turn(shift)};
  }

  const ConvexRing ring;
  const Double2 column_x, column_y, shift;

 private:
  Double2 turned(Double2 p) const { return column_x * p[0] + column_y * p[1]; }

  const bool mirrors_;
};

}  // namespace tricover::detail
