// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "contact/boundary_point.h"
#include "numbers/convex_hull.h"
#include "numbers/segment.h"

namespace tricover::detail {

/// The corners of a convex hull, counter-clockwise from the leftmost one. A segment has two, a point one. Signs are
/// rounded.
using Hull = std::vector<BoundaryPoint>;

inline Hull hullOf(std::vector<BoundaryPoint> points) {
  return convexHull(
      std::move(points), [](const BoundaryPoint& p) -> const Vec2& { return p.at; },
      [](const Vec2& p, const Vec2& q, const Vec2& r) { return cross(q - p, r - q) > 0; });
}

/// The points that may be corners of the hull: without those that are inside the triangle of the points beside them and
/// a middle, by twice its area more than `same_area`, which rounding may cost. Points of an outline are mostly left
/// out.
inline std::vector<BoundaryPoint> likelyCorners(const std::vector<BoundaryPoint>& points, double same_area) {
  constexpr std::size_t kWorthLooking = 32;
  if (points.size() < kWorthLooking) return points;
  const std::size_t quarter = points.size() / 4;
  const Vec2 middle = 0.25 * (points[0].at + points[quarter].at + points[2 * quarter].at + points[3 * quarter].at);
  std::vector<BoundaryPoint> likely(points.size());
  std::size_t count = 0;
  Vec2 u = points.back().at - middle, p = points.front().at - middle;
  double u_p = cross(u, p);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec2 v = points[k + 1 < points.size() ? k + 1 : 0].at - middle;
    const double p_v = cross(p, v), rest = cross(u, v) - u_p - p_v;
    const double least = std::min({u_p, p_v, rest}), most = std::max({u_p, p_v, rest});
    likely[count] = points[k];
    count += std::max(least, -most) > same_area ? 0 : 1;
    u = p, p = v, u_p = p_v;
  }
  likely.resize(count);
  return likely;
}

}  // namespace tricover::detail
