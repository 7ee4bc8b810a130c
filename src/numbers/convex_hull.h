// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tricover/pose.h"

namespace tricover::detail {

/// In lexicographic order: by x, then by y.
inline bool isBefore(const Vec2& p, const Vec2& q) { return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y(); }

/// The corners of the convex hull, counter-clockwise from the leftmost one, by Andrew's monotone chains in O(n log n).
/// A segment has two corners, a point one. at(point) is where a point is; turnsLeft(p, q, r) tells whether the path
/// through three such places turns left at q. If turnsLeft rounds, so does the hull.
template <typename Point, typename At, typename TurnsLeft>
std::vector<Point> convexHull(std::vector<Point> points, At at, TurnsLeft turnsLeft) {
  if (points.empty()) return points;
  const auto before = [&](const Point& p, const Point& q) { return isBefore(at(p), at(q)); };
  const auto ends = std::minmax_element(points.begin(), points.end(), before);
  const Point leftmost = *ends.first, rightmost = *ends.second;
  // Each chain has the points of its own side of the line between them, so that it drops few again.
  const auto upper = std::partition(points.begin(), points.end(),
                                    [&](const Point& p) { return turnsLeft(at(leftmost), at(p), at(rightmost)); });
  std::sort(points.begin(), upper, before);
  std::sort(upper, points.end(), [&](const Point& p, const Point& q) { return before(q, p); });
  std::vector<Point> hull;
  hull.reserve(points.size() + 2);
  const auto add = [&](const Point& point, std::size_t first) {
    while (hull.size() > first + 1 && !turnsLeft(at(hull.end()[-2]), at(hull.back()), at(point))) hull.pop_back();
    hull.push_back(point);
  };
  add(leftmost, 0);
  std::for_each(points.begin(), upper, [&](const Point& p) { add(p, 0); });
  add(rightmost, 0);
  std::for_each(upper, points.end(), [&, first = hull.size() - 1](const Point& p) { add(p, first); });
  if (hull.size() > 1) hull.pop_back();  // the leftmost once more
  if (hull.size() == 2 && at(hull[0]) == at(hull[1])) hull.pop_back();
  return hull;
}

}  // namespace tricover::detail
