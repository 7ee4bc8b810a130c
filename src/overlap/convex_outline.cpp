// SPDX-License-Identifier: BSD-3-Clause
#include "overlap/convex_outline.h"

#include <algorithm>
#include <utility>

#include "numbers/convex_hull.h"
#include "numbers/predicates.h"
#include "polygon/convexity.h"

namespace tricover::detail {
namespace {

std::vector<std::size_t> hullCorners(const PolygonData& polygon) {
  std::vector<std::size_t> vertices;
  vertices.reserve(polygon.path.size());
  for (std::size_t r = 0; r < polygon.ringCount(); ++r)
    for (std::size_t e = polygon.edgeBegin(r); e < polygon.edgeEnd(r); ++e) vertices.push_back(e);
  return convexHull(
      std::move(vertices), [&](std::size_t i) -> const Vec2& { return polygon.path[i]; },
      [](const Vec2& p, const Vec2& q, const Vec2& r) { return orientation(p, q, r) > 0; });
}

}  // namespace

ConvexOutline convexOutline(const PolygonData& polygon) {
  Convexity convexity = convexityOf(polygon);
  if (convexity.direction < 0) std::reverse(convexity.corners.begin(), convexity.corners.end());
  if (convexity.direction != 0) return {std::move(convexity.corners), true};
  std::vector<std::size_t> corners = hullCorners(polygon);
  // A ring without area covers all of its segment.
  const bool is_region = polygon.ringCount() == 1 && corners.size() < 3;
  return {std::move(corners), is_region};
}

}  // namespace tricover::detail
