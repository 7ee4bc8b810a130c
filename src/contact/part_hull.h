// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "contact/boundary_point.h"
#include "contact/slice.h"

namespace tricover::detail {

/// The corners of a convex hull, counter-clockwise from the leftmost one; a segment has two, a point one. As right as
/// the points are: signs are rounded.
using Hull = std::vector<BoundaryPoint>;

/// The hulls of one part of an overlap after the other, in the same memory.
class PartHull {
 public:
  /// same_area: of a triangle, twice, which may be none, as far as rounding tells.
  explicit PartHull(double same_area) : same_area_(same_area) {}

  const Hull& corners() const { return corners_; }
  /// Of points of which those that follow each other should be near each other.
  void make(const Slice<BoundaryPoint>& points);
  /// The hull of it and some points more, which it sorts.
  void grow(std::vector<BoundaryPoint>& more, Hull& hull) const;

 private:
  bool isWithin(double u_p, double p_v, double u_v) const;
  void takeLikely(const Slice<BoundaryPoint>& points);

  double same_area_;
  std::vector<BoundaryPoint> likely_;
  Hull corners_;
  std::size_t lower_ = 0;  ///< corners from the leftmost to the rightmost one
};

}  // namespace tricover::detail
