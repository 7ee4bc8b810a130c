// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "numbers/rounding.h"
#include "polygon/polygon_data.h"

namespace tricover::detail {

/// Whether points are within a tolerance of segments. Exact, for points at most a unit away from the polygon.
class Tolerance {
 public:
  Tolerance(const PolygonData& polygon, double tolerance) : polygon_(polygon), tolerance_(tolerance) {}

  /// The distance of a point from a segment, rounded, in units: it errs by less than kError, and of itself as much.
  double distance(const Vec2& p, const Vec2& v, const Vec2& w) const;

  bool holds(const Vec2& p, const Vec2& v, const Vec2& w) const { return holds(distance(p, v, w), p, v, w); }
  bool holds(double distance, const Vec2& p, const Vec2& v, const Vec2& w) const;

 private:
  /// In units of the roundoff, with |u| and D at most 4:
  ///   as for BesideSegment                                     13 |u| + 8 D
  ///   the foot is a point, and 1 - s is rounded: two roundings of coordinates up to 8, in any direction
  static constexpr double kError = 0x1p-45;

  static_assert(kError >= 4 * errorOf(13 + 8) + 2 * kRoot2 * 8 * errorOf(1));

  const PolygonData& polygon_;
  const double tolerance_;
};

/// The rings with fewer vertices, see Polygon::simplified().
std::vector<Ring> simplifiedRings(const PolygonData& polygon, double tolerance);

}  // namespace tricover::detail
