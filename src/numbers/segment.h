// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/pose.h"

namespace tricover::detail {

inline double cross(const Vec2& u, const Vec2& w) { return u.x() * w.y() - u.y() * w.x(); }

/// The point of the segment v w that is nearest to p, rounded; NaN where squares overflow.
inline Vec2 nearestOnSegment(const Vec2& p, const Vec2& v, const Vec2& w) {
  const Vec2 u = w - v;
  const double square = u.squaredNorm();
  if (square == 0) return v;
  const double s = (p - v).dot(u) / square;
  if (s <= 0) return v;
  if (s >= 1) return w;
  // From the nearer end: an end is met without rounding.
  return s <= 0.5 ? Vec2(v + s * u) : Vec2(w - (1 - s) * u);
}

inline double squaredDistanceToSegment(const Vec2& p, const Vec2& v, const Vec2& w) {
  return (nearestOnSegment(p, v, w) - p).squaredNorm();
}

}  // namespace tricover::detail
