// SPDX-License-Identifier: BSD-3-Clause
#include "convex_outline.h"

#include <algorithm>

namespace tricover::detail {

Outline convexHull(std::vector<BoundaryPoint> points) {
  std::sort(points.begin(), points.end(), [](const BoundaryPoint& p, const BoundaryPoint& q) {
    return p.at.x() != q.at.x() ? p.at.x() < q.at.x() : p.at.y() < q.at.y();
  });
  Outline hull;
  const auto add = [&hull](const BoundaryPoint& p, std::size_t floor) {
    while (hull.size() > floor && cross(hull.back().at - hull[hull.size() - 2].at, p.at - hull.back().at) <= 0)
      hull.pop_back();
    hull.push_back(p);
  };
  for (const BoundaryPoint& p : points) add(p, 1);
  const std::size_t upper = hull.size();
  for (auto p = points.rbegin() + 1; p < points.rend(); ++p) add(*p, upper);
  if (hull.size() > 1) hull.pop_back();
  return hull;
}

bool isConvex(const PolygonData& polygon) {
  const std::vector<Vec2>& path = polygon.path;
  const std::size_t n = path.size() - 1;
  if (polygon.ringCount() != 1) return false;
  std::size_t second = 1;
  while (second < n && path[second] == path[0]) ++second;
  const auto rises = [](const Vec2& p, const Vec2& q) { return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y(); };
  Vec2 p = path[0], q = path[second];
  int direction = 0, changes = 0;
  for (std::size_t i = second + 1; i <= n + second; ++i) {
    const Vec2& r = path[i % n];
    if (r == q) continue;
    const int turn = orientation(p, q, r);
    if (turn * direction < 0) return false;
    if (turn != 0) direction = turn;
    changes += rises(p, q) != rises(q, r);
    p = q;
    q = r;
  }
  return direction != 0 && changes == 2;
}

}  // namespace tricover::detail
