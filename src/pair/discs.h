// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "hierarchy/hierarchy.h"
#include "numbers/double2.h"
#include "numbers/predicates.h"
#include "numbers/rigidity.h"
#include "polygon/polygon_data.h"

namespace tricover::detail {

/// Discs of both polygons under their poses, seen from a point of a to one of b in the world: what decides without a
/// relative pose.
class Discs {
 public:
  Discs(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b)
      : a_(a),
        b_(b),
        columns_a_{load2(pose_a.data()), load2(pose_a.data() + 3)},
        columns_b_{load2(pose_b.data()), load2(pose_b.data() + 3)},
        shift_(load2(pose_b.data() + 6) - load2(pose_a.data() + 6)) {
    const Double2 apart = absolute(shift_);
    error_ = kPointsError * (a.extent + b.extent + apart[0] + apart[1]) + kTiny;
    way_ = between(a.origin, b.origin);
  }

  // What the sums of radii round by isn't counted below: kLargestDefect and kPointsError pay for it.

  /// The gap between the bounding discs, a lower bound of the distance, if it is above the margin; otherwise -1.
  double gap(double margin) const {
    const double square = squared(way_);
    const double sum = (a_.radius + b_.radius) * (1 + kLargestDefect) + error_, apart = sum + margin;
    if (!(squarable(apart) && square > roundedUp<kSquares>(apart * apart))) return -1;
    // The root of two roundings and its own; the difference, at most what the root is.
    return square < 0x1p1000 ? roundedDown<3>(std::sqrt(square)) - sum : margin;
  }

  /// How deep discs inside the two regions overlap, 0 if they are within the margin at least; otherwise -1.
  double depth(double margin) const {
    const InnerDisc disc_a(a_), disc_b(b_);
    if (!(disc_a.radius >= 0 && disc_b.radius >= 0)) return -1;
    const double square = squared(between(disc_a.center, disc_b.center));
    const double reach = (disc_a.radius + disc_b.radius) * (1 - kLargestDefect) - error_, within = reach + margin;
    if (!(squarable(within) && roundedUp<kSquares>(square) < within * within)) return -1;
    return std::max(roundedDown<2>(reach) - roundedUp<2>(std::sqrt(square)), 0.0);
  }

  /// R_b q + (shift - R_a p), in either coordinate, with lengths p, q <= sqrt2 e of points in the bounding boxes:
  ///   R_b q       products 1, sum 1, the last sum 1                      3 q
  ///   R_a p       products 1, sum 1, the difference 1, the last sum 1    4 p
  ///   shift       itself 1, the difference 1, the last sum 1             3 |t_b - t_a|_1
  /// and sqrt2 of it in any direction: at most 8 e.
  static constexpr double kPointsError = 16 * kUnitRoundoff;
  static_assert(kPointsError >= (1 + 1e-5) * kRoot2 * kRoot2 * errorOf(4));
  /// Between squares of lengths: the products and the sum of one, the product of the other and that of a length with a
  /// last rounding by itself.
  static constexpr int kSquares = 2 + 1 + 2;

  /// The largest disc known to be inside of a region. A point or segment has one of radius 0 around S, which is on it
  /// but for 2U: kPointsError is twice what it must be.
  struct InnerDisc {
    explicit InnerDisc(const PolygonData& polygon) {
      if (polygon.isDegenerate()) {
        center = polygon.origin;
        radius = 0;
      } else {
        const Hierarchy& tree = hierarchyOf(polygon);
        center = tree.inner_center;
        radius = tree.inner_radius > 0 ? tree.inner_radius : -1;  // the centre needn't be in the region
      }
    }

    Vec2 center;
    double radius;  ///< negative if there is none
  };

  /// From a's S to b's, and how far off a distance between two points may be.
  Double2 way() const { return way_; }
  double error() const { return error_; }
  /// R_a^T v, and a column of R_b.
  Double2 turnedToA(Double2 v) const {
    return Double2{columns_a_[0][0], columns_a_[1][0]} * v[0] + Double2{columns_a_[0][1], columns_a_[1][1]} * v[1];
  }
  Double2 columnOfB(int i) const { return columns_b_[i]; }

 private:
  Double2 between(const Vec2& p, const Vec2& q) const {
    return (columns_b_[0] * q.x() + columns_b_[1] * q.y()) + (shift_ - (columns_a_[0] * p.x() + columns_a_[1] * p.y()));
  }
  static double squared(Double2 d) { return dot(d, d); }

  const PolygonData &a_, &b_;
  Double2 columns_a_[2], columns_b_[2], shift_, way_;
  double error_;
};

}  // namespace tricover::detail
