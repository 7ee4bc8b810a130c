// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "contact/boundary_point.h"
#include "numbers/convex_hull.h"
#include "numbers/segment.h"

namespace tricover::detail {

/// The corners of a convex hull, counter-clockwise.
using Hull = std::vector<BoundaryPoint>;

/// As right as the points are: signs are rounded.
inline Hull hullOf(std::vector<BoundaryPoint> points) {
  return convexHull(
      std::move(points), [](const BoundaryPoint& p) -> const Vec2& { return p.at; },
      [](const Vec2& p, const Vec2& q, const Vec2& r) { return cross(q - p, r - q) > 0; });
}

/// Calls visit(from, to, normal, depth, deepest) for every face of the hull: `body` reaches `depth` behind it, with
/// `deepest`, which goes round the body as the face goes round the hull.
template <typename Visit>
void forEachFace(const Hull& hull, const Hull& body, Visit visit) {
  std::size_t deepest = 0;
  bool first = true;
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const BoundaryPoint &from = hull[k], &to = hull[k + 1 < hull.size() ? k + 1 : 0];
    const Vec2 way = to.at - from.at;
    if (way.isZero(0)) continue;
    const Vec2 normal = Vec2(way.y(), -way.x()).stableNormalized();
    const auto height = [&](std::size_t i) { return normal.dot(body[i].at - from.at); };
    if (first)
      for (std::size_t i = 1; i < body.size(); ++i) deepest = height(i) < height(deepest) ? i : deepest;
    first = false;
    for (std::size_t steps = 0; steps < body.size(); ++steps) {
      const std::size_t next = deepest + 1 < body.size() ? deepest + 1 : 0;
      if (height(next) > height(deepest)) break;
      deepest = next;
    }
    visit(from, to, normal, -height(deepest), body[deepest]);
  }
}

}  // namespace tricover::detail
