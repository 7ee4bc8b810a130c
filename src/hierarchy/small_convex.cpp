// SPDX-License-Identifier: BSD-3-Clause
#include "hierarchy/small_convex.h"

#include <algorithm>
#include <cmath>

#include "polygon/convexity.h"

namespace tricover::detail {
std::unique_ptr<const SmallConvex> makeSmallConvex(const PolygonData& polygon, const std::vector<Vec2>& local) {
  const std::size_t n = polygon.path.size() - 1;
  if (n > SmallConvex::kMost) return nullptr;
  const Convexity convexity = convexityOf(polygon);
  if (convexity.corners.size() != n) return nullptr;  // a straight vertex would be a half plane twice
  auto convex = std::make_unique<SmallConvex>();
  convex->lanes = n > kLanes ? SmallConvex::kMost : kLanes;
  convex->count = static_cast<int>(n);
  double shortest = 2;
  for (int i = 0; i < convex->lanes; ++i) {
    const std::size_t k = std::min(static_cast<std::size_t>(i), n - 1);
    const Vec2 edge = local[k + 1] - local[k];
    const double length = edge.norm();
    if (!(length > 0x1p-30)) return nullptr;  // its direction wouldn't survive rounding
    shortest = std::min(shortest, length);
    const Vec2 normal = Vec2(edge.y(), -edge.x()) * (convexity.direction / length);
    convex->x[i] = static_cast<float>(local[k].x());
    convex->y[i] = static_cast<float>(local[k].y());
    convex->nx[i] = static_cast<float>(normal.x());
    convex->ny[i] = static_cast<float>(normal.y());
    convex->d[i] = static_cast<float>(normal.dot(local[k]));
  }
  convex->shortest = static_cast<float>(shortest);
  return convex;
}

}  // namespace tricover::detail
