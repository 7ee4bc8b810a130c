// SPDX-License-Identifier: BSD-3-Clause
#include "overlap/disc_cover.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hierarchy/inclusion.h"
#include "numbers/segment.h"

namespace tricover::detail {

std::vector<Disc> coverByDiscs(const PolygonData& polygon, const Pose& pose, const std::vector<Vec2>& vertices,
                               const Vec2& origin, double unit, double noise) {
  constexpr int kGrid = 20;
  constexpr std::size_t kMost = 96;
  Vec2 low = vertices[0], high = low;
  for (const Vec2& p : vertices) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  std::vector<Disc> grid;
  for (int i = 0; i < kGrid * kGrid; ++i) {
    const int row = i / kGrid, column = i % kGrid;
    const Vec2 share((column + 0.5) / kGrid, (row + 0.5) / kGrid);
    const Vec2 p = low + share.cwiseProduct(high - low);
    double square = std::numeric_limits<double>::infinity();
    for (std::size_t r = 0; r < polygon.ringCount(); ++r)
      for (std::size_t e = polygon.edgeBegin(r); e < polygon.edgeEnd(r); ++e)
        square = std::min(square, squaredDistanceToSegment(p, vertices[e], vertices[e + 1]));
    // The boundary and, below, the way back to the polygon's frame are wrong by a few `noise`.
    grid.push_back({p, std::sqrt(square) - 16 * noise});
  }
  std::sort(grid.begin(), grid.end(), [](const Disc& c, const Disc& d) { return c.radius > d.radius; });
  const Eigen::Matrix2d back = pose.linear().inverse();
  std::vector<Disc> discs;
  for (const Disc& disc : grid) {
    if (discs.size() == kMost || !(disc.radius > 0)) break;
    const auto held = [&](const Disc& d) { return (d.center - disc.center).norm() < 0.5 * d.radius; };
    if (std::any_of(discs.begin(), discs.end(), held)) continue;
    const Vec2 local = polygon.origin + back * ((disc.center - origin) * unit);
    if (local.allFinite() && locateInPolygon(polygon, IncludedPoint::ofFrame(local)) == Location::Inside)
      discs.push_back(disc);
  }
  return discs;
}

}  // namespace tricover::detail
