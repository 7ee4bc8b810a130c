// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tricover/pose.h"

namespace tricover::detail {

/// In lexicographic order: by x, then by y.
inline bool isBefore(const Vec2& p, const Vec2& q) { return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y(); }

/// The corners of the convex hull, counter-clockwise from the leftmost one; a segment has two, a point one. By Andrew's
/// monotone chains, in O(n log n). at(point) is where a point is, and turnsLeft(p, q, r), of such places, whether the
/// way through them turns to the left at q: what that decides rounded, the hull is right to.
template <typename Point, typename At, typename TurnsLeft>
std::vector<Point> convexHull(std::vector<Point> points, At at, TurnsLeft turnsLeft) {
  std::sort(points.begin(), points.end(), [&](const Point& p, const Point& q) { return isBefore(at(p), at(q)); });
  std::vector<Point> hull;
  hull.reserve(points.size() + 1);
  const auto add = [&](const Point& p, std::size_t floor) {
    while (hull.size() > floor && !turnsLeft(at(hull[hull.size() - 2]), at(hull.back()), at(p))) hull.pop_back();
    hull.push_back(p);
  };
  for (const Point& p : points) add(p, 1);
  const std::size_t lower = hull.size();
  for (auto p = points.rbegin() + (points.empty() ? 0 : 1); p < points.rend(); ++p) add(*p, lower);
  if (hull.size() > 1) hull.pop_back();  // the first once more
  if (hull.size() == 2 && at(hull[0]) == at(hull[1])) hull.pop_back();
  return hull;
}

}  // namespace tricover::detail
