// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "contact/boundary_point.h"
#include "numbers/convex_hull.h"
#include "numbers/segment.h"

namespace tricover::detail {

/// The corners of a convex hull, counter-clockwise from the leftmost one. A segment has two, a point one. Signs are
/// rounded.
using Hull = std::vector<BoundaryPoint>;

inline Hull hullOf(std::vector<BoundaryPoint> points) {
  return convexHull(
      std::move(points), [](const BoundaryPoint& p) -> const Vec2& { return p.at; },
      [](const Vec2& p, const Vec2& q, const Vec2& r) { return cross(q - p, r - q) > 0; });
}

/// Calls visit(from, to, normal, depth, deepest) for every face of the hull that is wanted, by isWanted(from, to):
/// `body` reaches `depth` behind it, with `deepest`, which goes round the body as the face goes round the hull.
template <typename IsWanted, typename Visit>
void forEachFace(const Hull& hull, const Hull& body, IsWanted isWanted, Visit visit) {
  std::size_t deepest = 0;
  Vec2 last_way = Vec2::Zero();
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const BoundaryPoint &from = hull[k], &to = hull[k + 1 < hull.size() ? k + 1 : 0];
    if (!isWanted(from, to)) continue;
    const Vec2 way = to.at - from.at;
    if (way.isZero(0)) continue;
    const Vec2 normal = Vec2(way.y(), -way.x()).stableNormalized();
    const auto height = [&](std::size_t i) { return normal.dot(body[i].at - from.at); };
    double lowest = height(deepest);
    // After a half turn, and at first, there may be rises on the way to it, and nearly so rises by rounding.
    if (!(cross(last_way, way) > 0 && last_way.dot(way) > 0)) {
      for (std::size_t i = 0; i < body.size(); ++i) {
        const double at = height(i);
        deepest = at < lowest ? i : deepest;
        lowest = std::min(lowest, at);
      }
    }
    last_way = way;
    for (std::size_t steps = 0; steps < body.size(); ++steps) {
      const std::size_t next = deepest + 1 < body.size() ? deepest + 1 : 0;
      const double next_height = height(next);
      if (next_height > lowest) break;
      deepest = next;
      lowest = next_height;
    }
    visit(from, to, normal, -lowest, body[deepest]);
  }
}

}  // namespace tricover::detail
