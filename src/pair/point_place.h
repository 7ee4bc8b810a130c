// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "hierarchy/simd.h"
#include "numbers/double2.h"
#include "numbers/rigidity.h"
#include "pair/discs.h"
#include "polygon/polygon_data.h"
#include "tricover/pose.h"

namespace tricover::detail {

/// Where a point b is, seen from a, without a relative pose.
struct PointPlace {
  PointPlace(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b) {
    const Double2 a0 = load2(pose_a.data()), a1 = load2(pose_a.data() + 3);
    const Double2 b0 = load2(pose_b.data()), b1 = load2(pose_b.data() + 3);
    const Double2 shift = load2(pose_b.data() + 6) - load2(pose_a.data() + 6), apart = absolute(shift);
    const Double2 way = (b0 * b.origin.x() + b1 * b.origin.y()) + (shift - (a0 * a.origin.x() + a1 * a.origin.y()));
    const double error = Discs::kPointsError * (a.extent + b.extent + apart[0] + apart[1]) + kTiny;
    defect = Gram(a0, a1).defect();
    const Double2 x = a0 * way, y = a1 * way, away = absolute(way);
    // R^T stands for R^-1: their difference is R^T R - I, at most the defect less 16U, times R^-1. Two products and
    // their sum round by 2 sqrt2 U. Of the largest polygons the hierarchy knows nothing.
    const double in_frame = error + defect * (1 + kLargestDefect) * (away[0] + away[1]);
    place = {(x[0] + x[1]) * a.inverse_unit, (y[0] + y[1]) * a.inverse_unit,
             a.fitsUnit() ? in_frame * a.inverse_unit : std::numeric_limits<double>::infinity()};
  }

  double defect;  ///< PosedPair::scale_defect
  Place place;    ///< in a's hierarchy
};

/// A lower bound, in units, of the distance of a place from the box around everything; not positive where it may be
/// inside. The box's axis is of unit length as far as floats are: kGapRounding is far more than doubles add to that.
inline double distanceFromRoot(const Box& root, const Place& place) {
  const double dx = place.x - root.x, dy = place.y - root.y;
  const double along = std::max(std::abs(dx * root.ux + dy * root.uy) - root.along, 0.0);
  const double across = std::max(std::abs(dy * root.ux - dx * root.uy) - root.across, 0.0);
  const double squares = along * along + across * across;
  const double apart = squares < 1e300 ? std::sqrt(squares) : std::max(along, across);  // squares may overflow
  return apart - (std::abs(dx) + std::abs(dy) + 4) * kGapRounding - place.error;
}

}  // namespace tricover::detail
