// SPDX-License-Identifier: BSD-3-Clause
#include "contact/convex_outline.h"

#include <algorithm>
#include <memory>
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

ConvexOutline makeOutline(const PolygonData& polygon) {
  Convexity convexity = convexityOf(polygon);
  ConvexOutline outline;
  if (convexity.direction != 0) {
    if (convexity.direction < 0) std::reverse(convexity.corners.begin(), convexity.corners.end());
    outline.corners = std::move(convexity.corners);
    outline.is_region = true;
    if (outline.corners.size() + 1 == polygon.path.size()) outline.turn = convexity.direction;
    return outline;
  }
  outline.corners = hullCorners(polygon);
  // A ring without area covers all of its segment.
  outline.is_region = polygon.ringCount() == 1 && outline.corners.size() < 3;
  return outline;
}

}  // namespace

const ConvexOutline& convexOutlineOf(const PolygonData& polygon) {
  const Derived::Thing* outline = polygon.outline.ifBuilt();
  if (outline == nullptr)
    outline = polygon.outline.built([&] { return std::make_unique<const ConvexOutline>(makeOutline(polygon)); });
  return *static_cast<const ConvexOutline*>(outline);
}

}  // namespace tricover::detail
