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
  if (polygon.ringCount() != 1) return false;
  std::vector<Vec2> ring;
  for (const Vec2& p : polygon.path)
    if (ring.empty() || ring.back() != p) ring.push_back(p);
  if (ring.size() < 4) return false;
  ring.push_back(ring[1]);
  int direction = 0, changes = 0;
  const auto rises = [](const Vec2& p, const Vec2& q) { return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y(); };
  for (std::size_t i = 0; i + 2 < ring.size(); ++i) {
    const int turn = orientation(ring[i], ring[i + 1], ring[i + 2]);
    if (turn * direction < 0) return false;
    if (turn != 0) direction = turn;
    changes += rises(ring[i], ring[i + 1]) != rises(ring[i + 1], ring[i + 2]);
  }
  return direction != 0 && changes == 2;
}

}  // namespace tricover::detail
