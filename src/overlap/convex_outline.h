// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "overlap/overlap_components.h"

namespace tricover::detail {

/// A convex ring, counter-clockwise.
using Outline = std::vector<BoundaryPoint>;

/// By Andrew's monotone chain, in O(n log n).
Outline convexHull(std::vector<BoundaryPoint> points);

/// Calls visit(from, to, normal, depth, deepest) for every face of the outline: `body` reaches `depth` behind it, with
/// `deepest`, which goes round the body as the face goes round the outline.
template <typename Visit>
void forEachFace(const Outline& outline, const Outline& body, Visit visit) {
  std::size_t deepest = 0;
  bool first = true;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const BoundaryPoint &from = outline[k], &to = outline[k + 1 < outline.size() ? k + 1 : 0];
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
