// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "polygon/polygon_data.h"
#include "tricover/pose.h"

namespace tricover::detail {

/// A box along the world's axes.
struct Bounds {
  double min_x, min_y, max_x, max_y;

  bool meets(const Bounds& other) const {
    return min_x <= other.max_x && other.min_x <= max_x && min_y <= other.max_y && other.min_y <= max_y;
  }
  bool contains(const Bounds& other) const {
    return min_x <= other.min_x && other.max_x <= max_x && min_y <= other.min_y && other.max_y <= max_y;
  }
};

inline Bounds unite(const Bounds& p, const Bounds& q) {
  return {std::min(p.min_x, q.min_x), std::min(p.min_y, q.min_y), std::max(p.max_x, q.max_x),
          std::max(p.max_y, q.max_y)};
}

/// A box around all points that are within `reach` of the posed polygon, rounded outwards. It never holds NaN. Builds
/// the hierarchy.
Bounds boundsOf(const PolygonData& polygon, const Pose& pose, double reach);

}  // namespace tricover::detail
