// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "numbers/predicates.h"
#include "numbers/rigidity.h"
#include "polygon/polygon_data.h"
#include "tricover/location.h"

namespace tricover::detail {

inline bool isInside(const Fill& fill, int winding) {
  return (fill.rule == FillRule::EvenOdd ? winding % 2 != 0 : winding != 0) != fill.is_complement;
}

/// Where a point is, and, unless it is on the boundary, how often the rings wind around it in the polygon's own frame.
struct Inclusion {
  Location location;
  int winding;
};

/// A point that is located in a polygon. The point is given twice: in the polygon's frame to within its error, and
/// exactly in the world, where `pose` (none: the identity) puts the polygon.
struct IncludedPoint {
  const Pose* pose;
  ApproxPoint approx;
  PosedPoint exact;

  /// A point of the polygon's own frame, exactly.
  static IncludedPoint ofFrame(const Vec2& p) { return {nullptr, {p.x(), p.y(), 0}, {nullptr, p}}; }

  /// The sign of the signed area |v w p| in the polygon's frame, for v and w of that frame. Exact.
  int side(const Vec2& v, const Vec2& w) const {
    const int sign = orientFilter({v.x(), v.y(), 0}, {w.x(), w.y(), 0}, approx);
    if (sign != kUncertain) return sign;
    const int in_world = orientExact({pose, v}, {pose, w}, exact);
    return pose != nullptr && isMirrored(*pose) ? -in_world : in_world;
  }
};

/// Whether a point is certainly outside of the disc around all rings, where no ring winds around it.
inline bool outsideBoundingDisc(const PolygonData& polygon, const ApproxPoint& p) {
  return normBelow(p.x - polygon.origin.x(), p.y - polygon.origin.y()) >
         (polygon.radius + 2 * p.error) * (1 + 4 * kUnitRoundoff);
}

/// Where such a point is.
inline Inclusion includeFarAway(const PolygonData& polygon) {
  return {polygon.fill.is_complement ? Location::Inside : Location::Outside, 0};
}

/// The sum of the paper's Algorithm 1 with exact signs, twice the winding number, edge by edge. Any origin s serves
/// that is not the point itself; the point lies in the triangle (s, v, w) of sign g if it is between the rays s->v and
/// s->w (g d_v >= 0 >= g d_w, with d_v the sign of |s v p|) and on s's side of the edge; on one of the rays it counts
/// half (the neighbouring triangle counts the other half).
///
/// The edges of those triangles are what the ray from the point away from s meets.
class CoveringSum {
 public:
  CoveringSum(const PolygonData& polygon, const IncludedPoint& point) : CoveringSum(polygon, point, polygon.origin) {}
  /// From `origin`, unless the point is near it.
  CoveringSum(const PolygonData& polygon, const IncludedPoint& point, const Vec2& origin);

  /// Takes the triangle of the edge at this position. False if the point is on the edge: nothing else matters then.
  bool add(EdgePosition edge);
  void addAll();

  /// Once every triangle that holds the point has been added.
  Inclusion result() const;

  const PolygonData& polygon() const { return polygon_; }
  const IncludedPoint& point() const { return point_; }
  const Vec2& origin() const { return s_; }

 private:
  int sign(const Vec2& v, const Vec2& w) const;
  bool between(const Vec2& v, const Vec2& w) const;

  const PolygonData& polygon_;
  const IncludedPoint& point_;
  Vec2 s_;
  int sum_ = 0;
  bool on_boundary_ = false;
};

}  // namespace tricover::detail
