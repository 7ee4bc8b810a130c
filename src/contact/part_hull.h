// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>

#include "contact/boundary_point.h"
#include "contact/slice.h"

namespace tricover::detail {

/// The corners of a convex hull, counter-clockwise from the leftmost one; a segment has two, a point one. As right as
/// the points are: signs are rounded.
using Hull = Slice<BoundaryPoint>;

/// The hulls of one part of an overlap after the other, in the same memory.
class PartHull {
 public:
  /// same_area: of a triangle, twice, which may be none, as far as rounding tells.
  explicit PartHull(double same_area) : same_area_(same_area) {}

  /// Of points of which those that follow each other should be near each other. Room for `more` of either side.
  void make(const Slice<BoundaryPoint>& points, std::size_t more);
  const Hull& corners() const { return corners_; }
  /// The hull of it and some points of one side more.
  void add(const BoundaryPoint& point) { *likely_end_++ = point; }
  const Hull& grow(int side);
  const Hull& grown(int side) const { return grown_[side]; }

 private:
  std::size_t likelySize() const { return static_cast<std::size_t>(likely_end_ - likely_); }
  void takeLikely(const Slice<BoundaryPoint>& points);
  void leaveOutWithin(const Vec2& middle);

  double same_area_;
  static constexpr std::size_t kFew = 512;
  BoundaryPoint few_[kFew];  ///< room for most parts
  std::size_t capacity_ = 0;
  std::unique_ptr<BoundaryPoint[]> room_;
  BoundaryPoint *likely_ = nullptr, *likely_end_ = nullptr;  ///< those that may be corners
  BoundaryPoint* place_of_[2] = {};                          ///< grown
  Hull corners_, grown_[2];
  std::size_t lower_ = 0;  ///< corners from the leftmost to the rightmost one
};

}  // namespace tricover::detail
