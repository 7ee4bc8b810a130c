// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tricover/pose.h"

namespace tricover::detail {

/// In lexicographic order: by x, then by y.
inline bool isBefore(const Vec2& p, const Vec2& q) { return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y(); }

/// The corners of the convex hull, counter-clockwise from the leftmost one, by Andrew's monotone chains in O(n log n). A
/// segment has two corners, a point one. at(point) is where a point is; turnsLeft(p, q, r) tells whether the path through
/// three such places turns left at q. If turnsLeft rounds, so does the hull.
template <typename Point, typename At, typename TurnsLeft>
std::vector<Point> convexHull(std::vector<Point> points, At at, TurnsLeft turnsLeft) {
  if (points.empty()) return points;
  std::sort(points.begin(), points.end(), [&](const Point& p, const Point& q) { return isBefore(at(p), at(q)); });
  std::vector<Point> hull;
  hull.reserve(points.size() + 2);
  const auto add = [&](const Point& point, std::size_t first) {
    while (hull.size() > first + 1 && !turnsLeft(at(hull.end()[-2]), at(hull.back()), at(point))) hull.pop_back();
    hull.push_back(point);
  };
  for (const Point& p : points) add(p, 0);
  const std::size_t rightmost = hull.size() - 1;
  for (auto p = points.rbegin() + 1; p < points.rend(); ++p) add(*p, rightmost);
  if (hull.size() > 1) hull.pop_back();  // the leftmost once more
  if (hull.size() == 2 && at(hull[0]) == at(hull[1])) hull.pop_back();
  return hull;
}

}  // namespace tricover::detail
