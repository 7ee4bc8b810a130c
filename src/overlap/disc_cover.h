// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "polygon/polygon_data.h"

namespace tricover::detail {

struct Disc {
  Vec2 center;
  double radius;
};

/// Discs that lie in the polygon's region under a pose without its translation, many enough to fill most of it, in
/// units around `origin`, where `vertices` (by position in the path) are, to within `noise`. O(n) with a large
/// constant.
std::vector<Disc> coverByDiscs(const PolygonData& polygon, const Pose& pose, const std::vector<Vec2>& vertices,
                               const Vec2& origin, double unit, double noise);

}  // namespace tricover::detail
