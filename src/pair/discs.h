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
    error_ = 16 * kUnitRoundoff * (a.extent + b.extent + apart[0] + apart[1]) + kTiny;
  }

  /// The gap between the bounding discs, a lower bound of the distance, if it is above the margin; otherwise -1.
  double gap(double margin) const {
    const double square = squaredBetween(a_.origin, b_.origin);
    const double sum = (a_.radius + b_.radius) * (1 + kLargestDefect) + error_, apart = sum + margin;
    if (!(squarable(apart) && square > apart * apart * (1 + 16 * kUnitRoundoff))) return -1;
    return square < 0x1p1000 ? std::sqrt(square) * (1 - 4 * kUnitRoundoff) - sum * (1 + 8 * kUnitRoundoff) : margin;
  }

  /// How deep discs inside the two regions overlap; otherwise -1.
  double depth() const {
    const Hierarchy &tree_a = hierarchyOf(a_), &tree_b = hierarchyOf(b_);
    if (!(tree_a.inner_radius > 0 && tree_b.inner_radius > 0)) return -1;  // the centre needn't be in the region
    const double square = squaredBetween(tree_a.inner_center, tree_b.inner_center);
    const double reach = (tree_a.inner_radius + tree_b.inner_radius) * (1 - kLargestDefect) - error_;
    if (!(squarable(reach) && square * (1 + 16 * kUnitRoundoff) < reach * reach)) return -1;
    return reach * (1 - 8 * kUnitRoundoff) - std::sqrt(square) * (1 + 8 * kUnitRoundoff);
  }

 private:
  double squaredBetween(const Vec2& p, const Vec2& q) const {
    const Double2 d =
        (columns_b_[0] * q.x() + columns_b_[1] * q.y()) + (shift_ - (columns_a_[0] * p.x() + columns_a_[1] * p.y()));
    const Double2 squares = d * d;
    return squares[0] + squares[1];
  }

  const PolygonData &a_, &b_;
  Double2 columns_a_[2], columns_b_[2], shift_;
  double error_;  ///< of a distance between two points
};

}  // namespace tricover::detail
