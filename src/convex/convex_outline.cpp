// SPDX-License-Identifier: BSD-3-Clause
#include "convex/convex_outline.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

#include "numbers/convex_hull.h"
#include "numbers/predicates.h"

namespace tricover::detail {
namespace {

std::vector<EdgePosition> hullCorners(const PolygonData& polygon) {
  std::vector<EdgePosition> vertices;
  vertices.reserve(polygon.path.size());
  for (std::size_t r = 0; r < polygon.ringCount(); ++r)
    for (EdgePosition e = polygon.edgeBegin(r); e < polygon.edgeEnd(r); ++e) vertices.push_back(e);
  return convexHull(
      std::move(vertices), [&](EdgePosition i) -> const Vec2& { return polygon.path[i]; },
      [](const Vec2& p, const Vec2& q, const Vec2& r) { return orientation(p, q, r) > 0; });
}

ConvexOutline makeOutline(const PolygonData& polygon) {
  const Convexity& convexity = convexityOf(polygon);
  ConvexOutline outline;
  if (convexity.direction != 0) {
    outline.corners = convexity.corners;
    if (!convexity.has_others) {
      outline.corners.resize(polygon.path.size() - 1);
      std::iota(outline.corners.begin(), outline.corners.end(), EdgePosition{0});
    }
    outline.forward = convexity.direction > 0;
    if (!outline.forward) std::reverse(outline.corners.begin(), outline.corners.end());
    const auto leftmost =
        std::min_element(outline.corners.begin(), outline.corners.end(),
                         [&](EdgePosition i, EdgePosition j) { return isBefore(polygon.path[i], polygon.path[j]); });
    std::rotate(outline.corners.begin(), leftmost, outline.corners.end());
    outline.is_region = true;
  } else {
    outline.corners = hullCorners(polygon);
    // A ring without area covers all of its segment.
    outline.is_region = polygon.ringCount() == 1 && outline.corners.size() < 3;
  }
  outline.points.reserve(outline.corners.size() + 1);
  for (const EdgePosition corner : outline.corners) outline.points.push_back(polygon.path[corner]);
  outline.points.push_back(outline.points.front());
  return outline;
}

}  // namespace

const ConvexOutline& findConvexOutline(const PolygonData& polygon) {
  const Derived::Thing* outline =
      convexityOf(polygon).outline.built([&] { return std::make_unique<const ConvexOutline>(makeOutline(polygon)); });
  return *static_cast<const ConvexOutline*>(outline);
}

EdgePosition pathEdge(const PolygonData& polygon, const ConvexOutline& outline, std::size_t k, const Vec2& p) {
  const std::size_t next = k + 1 < outline.corners.size() ? k + 1 : 0, first = outline.forward ? k : next;
  if (outline.corners.size() + 1 == polygon.path.size()) return outline.corners[first];  // all vertices are corners
  return edgeBeside(polygon, outline.corners[first], outline.corners[outline.forward ? next : k], p);
}

}  // namespace tricover::detail
