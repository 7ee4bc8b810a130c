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

}  // namespace tricover::detail
