// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>

#include "tricover/polygon.h"

namespace tricover_fcl {

/// Whether the two edges (-1: none) cross, and go on to do so when either is moved by `touch`, for certain: the ends of
/// each are on both sides of the other's line, farther from it than that. Rounding counts as touching.
inline bool crossDeeply(const tricover::Polygon& a, const tricover::Pose& pose_a, tricover::EdgeIndex edge_a,
                        const tricover::Polygon& b, const tricover::Pose& pose_b, tricover::EdgeIndex edge_b,
                        double touch) {
  if (edge_a < 0 || edge_b < 0) return false;
  // A posed vertex errs by less than 4 roundings of what it is added from, which this size bounds.
  const auto size = [](const tricover::Polygon& polygon, const tricover::Pose& pose, tricover::EdgeIndex edge) {
    return 3 * (polygon.edgeStart(edge).lpNorm<1>() + polygon.edgeEnd(edge).lpNorm<1>()) +
           pose.translation().lpNorm<1>();
  };
  const double error = touch + 0x1p-48 * (size(a, pose_a, edge_a) + size(b, pose_b, edge_b));
  const tricover::Vec2 p = pose_a * a.edgeStart(edge_a), q = pose_a * a.edgeEnd(edge_a),
                       r = pose_b * b.edgeStart(edge_b), s = pose_b * b.edgeEnd(edge_b);
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
