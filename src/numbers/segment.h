// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>

#include "tricover/pose.h"

namespace tricover::detail {

inline double cross(const Vec2& u, const Vec2& w) { return u.x() * w.y() - u.y() * w.x(); }

/// How far along u the point of a segment is that is nearest to p, from 0 at v to `length`; in lengths of u, whose
/// square is given.
inline double footAlong(const Vec2& p, const Vec2& v, const Vec2& u, double square, double length) {
  return std::clamp((p - v).dot(u) / square, 0.0, length);
}

/// The point of the segment v w that is nearest to p, rounded; NaN where squares overflow.
inline Vec2 nearestOnSegment(const Vec2& p, const Vec2& v, const Vec2& w) {
  const Vec2 u = w - v;
  const double square = u.squaredNorm();
  if (square == 0) return v;
  const double s = footAlong(p, v, u, square, 1);
  // From the nearer end: an end is met without rounding.
  return s <= 0.5 ? Vec2(v + s * u) : Vec2(w - (1 - s) * u);
}

inline double squaredDistanceToSegment(const Vec2& p, const Vec2& v, const Vec2& w) {
  return (nearestOnSegment(p, v, w) - p).squaredNorm();
}

/// A segment.
struct Ends {
  Vec2 v, w;
};

/// Where two segments are nearest to each other, rounded, if they don't cross.
struct NearestPlaces {
  Vec2 way() const { return on_b - on_a; }
  Vec2 on_a, on_b;
};
/// offer(places), one of which is that.
template <typename Offer>
void forEachNearest(const Ends& a, const Ends& b, const Offer& offer) {
  for (const Vec2& p : {a.v, a.w}) offer(NearestPlaces{p, nearestOnSegment(p, b.v, b.w)});
  for (const Vec2& q : {b.v, b.w}) offer(NearestPlaces{nearestOnSegment(q, a.v, a.w), q});
}
inline NearestPlaces nearestPlaces(const Ends& a, const Ends& b) {
  NearestPlaces nearest{a.v, b.v};
  double least = std::numeric_limits<double>::infinity();
  forEachNearest(a, b, [&](const NearestPlaces& places) {
    const double square = places.way().squaredNorm();
    if (square < least) least = square, nearest = places;
  });
  return nearest;
}

}  // namespace tricover::detail
