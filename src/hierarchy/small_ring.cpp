// SPDX-License-Identifier: BSD-3-Clause
#include "hierarchy/small_ring.h"

#include <algorithm>
#include <cmath>

namespace tricover::detail {

std::unique_ptr<const SmallRing> makeSmallRing(const PolygonData& polygon, const Convexity& convexity,
                                               const std::vector<Vec2>& local) {
  const std::size_t n = polygon.path.size() - 1;
  if (polygon.ringCount() != 1 || n > SmallRing::kMost) return nullptr;
  auto ring = std::make_unique<SmallRing>();
  ring->lanes = n > kLanes ? SmallRing::kMost : kLanes;
  ring->count = static_cast<int>(n);
  ring->fill = polygon.fill;
  ring->convex = convexity.corners.size() == n;  // a straight vertex would be a half plane twice
  const double outwards = convexity.direction < 0 ? -1 : 1;
  for (int i = 0; i < ring->lanes; ++i) {
    const std::size_t k = std::min(static_cast<std::size_t>(i), n - 1);
    const Vec2 edge = local[k + 1] - local[k];
    const double length = edge.norm();
    if (!(length > 0x1p-30)) return nullptr;  // its direction wouldn't survive rounding
    const Vec2 normal = Vec2(edge.y(), -edge.x()) * (outwards / length);
    ring->x[i] = static_cast<float>(local[k].x());
    ring->y[i] = static_cast<float>(local[k].y());
    ring->nx[i] = static_cast<float>(normal.x());
    ring->ny[i] = static_cast<float>(normal.y());
    ring->d[i] = static_cast<float>(normal.dot(local[k]));
    const Vec2 middle = local[k] + 0.5 * edge;
    ring->middle[i] = static_cast<float>(normal.x() * middle.y() - normal.y() * middle.x());
    ring->half[i] = static_cast<float>(0.5 * length);
  }
  const auto [low_x, high_x] = std::minmax_element(ring->x, ring->x + ring->lanes);
  const auto [low_y, high_y] = std::minmax_element(ring->y, ring->y + ring->lanes);
  ring->low_x = *low_x, ring->high_x = *high_x;
  ring->low_y = *low_y, ring->high_y = *high_y;
  return ring;
}

}  // namespace tricover::detail
