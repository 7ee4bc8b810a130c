// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>

#include "tricover/pose.h"

namespace tricover::detail {

/// Of a part of the overlap, along a unit vector `up`.
struct PartMiddle {
  Vec2 deepest;  ///< its lowest point
  Vec2 middle;   ///< of what its hull has of the line along `up` through the deepest point, or the middle of those
};

/// By points of the part, among them all corners, and its hull, counter-clockwise. What is less than `error` apart
/// counts as equally deep.
template <typename Points, typename Hull>
PartMiddle partMiddle(const Points& points, const Hull& hull, const Vec2& up, double error) {
  const Vec2 side(-up.y(), up.x());
  double lowest = std::numeric_limits<double>::infinity(), first = lowest, last = -lowest;
  Vec2 deepest = Vec2::Zero();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double height = up.dot(points[k]);
    if (height < lowest) deepest = points[k];
    lowest = std::min(lowest, height);
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (up.dot(points[k]) > lowest + error) continue;
    first = std::min(first, side.dot(points[k]));
    last = std::max(last, side.dot(points[k]));
  }
  const double across = 0.5 * first + 0.5 * last;
  double highest = lowest;
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const Vec2 &p = hull[k], &q = hull[k + 1 < hull.size() ? k + 1 : 0];
    const double from = side.dot(p) - across, to = side.dot(q) - across;
    if ((from > 0 && to > 0) || (from < 0 && to < 0)) continue;
    highest = std::max(highest, up.dot(from != to ? Vec2(p + from / (from - to) * (q - p)) : p));
  }
  return {deepest, (0.5 * lowest + 0.5 * highest) * up + across * side};
}

}  // namespace tricover::detail
