// SPDX-License-Identifier: BSD-3-Clause
#include "overlap/convex_outline.h"

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

}  // namespace tricover::detail
