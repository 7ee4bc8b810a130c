// SPDX-License-Identifier: BSD-3-Clause
#include "hierarchy/small_convex.h"

#include <algorithm>
#include <cmath>

#include "numbers/predicates.h"

namespace tricover::detail {
namespace {

/// 1 or -1 for a strictly convex ring of that direction, otherwise 0: it turns the same way at every vertex, and goes
/// around once (its x falls and rises once each).
int convexDirection(const PolygonData& polygon) {
  const std::size_t n = polygon.path.size() - 1;
  const int direction = orientation(polygon.path[0], polygon.path[1], polygon.path[2]);
  int changes = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &p = polygon.path[i], &q = polygon.path[(i + 1) % n], &r = polygon.path[(i + 2) % n];
    if (orientation(p, q, r) != direction) return 0;
    changes += (q.x() > p.x()) != (r.x() > q.x());
  }
  return changes == 2 ? direction : 0;
}

}  // namespace

std::unique_ptr<const SmallConvex> makeSmallConvex(const PolygonData& polygon, const std::vector<Vec2>& local) {
  const std::size_t n = polygon.path.size() - 1;
  if (polygon.ringCount() != 1 || n > SmallConvex::kMost) return nullptr;
  const int direction = convexDirection(polygon);
  if (direction == 0) return nullptr;
  auto convex = std::make_unique<SmallConvex>();
  convex->lanes = n > kLanes ? SmallConvex::kMost : kLanes;
  for (int i = 0; i < convex->lanes; ++i) {
    const std::size_t k = std::min(static_cast<std::size_t>(i), n - 1);
    const Vec2 edge = local[k + 1] - local[k];
    const double length = edge.norm();
    if (!(length > 0x1p-30)) return nullptr;  // its direction wouldn't survive rounding
    const Vec2 normal = Vec2(edge.y(), -edge.x()) * (direction / length);
    convex->x[i] = static_cast<float>(local[k].x());
    convex->y[i] = static_cast<float>(local[k].y());
    convex->nx[i] = static_cast<float>(normal.x());
    convex->ny[i] = static_cast<float>(normal.y());
    convex->d[i] = static_cast<float>(normal.dot(local[k]));
  }
  return convex;
}

}  // namespace tricover::detail
