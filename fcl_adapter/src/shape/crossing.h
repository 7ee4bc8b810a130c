// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>

#include "tricover/polygon.h"

namespace tricover_fcl {

/// Whether the two edges (-1: none) cross, and go on to do so when either is moved by `touch`, for certain: the ends of
/// each are on both sides of the other's line, farther from it than that. Rounding counts as touching.
inline bool crossDeeply(const tricover::Polygon& a, const tricover::Pose& pose_a, std::ptrdiff_t edge_a,
                        const tricover::Polygon& b, const tricover::Pose& pose_b, std::ptrdiff_t edge_b, double touch) {
  if (edge_a < 0 || edge_b < 0) return false;
  const auto i = static_cast<std::size_t>(edge_a), j = static_cast<std::size_t>(edge_b);
  // A posed vertex errs by less than 4 roundings of what it is added from, which this size bounds.
  const auto size = [](const tricover::Polygon& polygon, const tricover::Pose& pose, std::size_t edge) {
    return 3 * (polygon.edgeStart(edge).lpNorm<1>() + polygon.edgeEnd(edge).lpNorm<1>()) +
           pose.translation().lpNorm<1>();
  };
  const double error = touch + 0x1p-48 * (size(a, pose_a, i) + size(b, pose_b, j));
  const tricover::Vec2 p = pose_a * a.edgeStart(i), q = pose_a * a.edgeEnd(i), r = pose_b * b.edgeStart(j),
                       s = pose_b * b.edgeEnd(j);
  const auto separates = [error](const tricover::Vec2& from, const tricover::Vec2& to, const tricover::Vec2& left,
                                 const tricover::Vec2& right) {
    const tricover::Vec2 along = to - from;
    const auto above = [&](const tricover::Vec2& end) {
      return along.x() * (end.y() - from.y()) - along.y() * (end.x() - from.x());
    };
    const double least =
        4 * error * (along.norm() + (left - from).norm() + (right - from).norm()) + 1e-300;  // underflow
    return (above(left) > least && above(right) < -least) || (above(left) < -least && above(right) > least);
  };
  return separates(p, q, r, s) && separates(r, s, p, q);
}

}  // namespace tricover_fcl
