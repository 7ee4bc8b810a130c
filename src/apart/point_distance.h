// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "apart/edge_distance.h"
#include "numbers/double2.h"
#include "polygon/polygon_data.h"
#include "tricover/pose.h"

namespace tricover::detail {

/// The distance of two points by plain doubles, as exact as EdgeDistances::at(); negative where that isn't certain.
///
/// With M = |p|_1 + |q|_1 + |t|_1, t = t_b - t_a, rows of R being unit vectors but for 1e-6, in units of U:
///   R q + t - R p   products 1, sum 1, two more sums 2; t itself 1, two sums 2    4 M in either coordinate
///   the square      twice sqrt2 4 M |w|, products and sum 2                       halved by the root, and its own 1
/// which is 5.7 M + 2 d: below 32 d, kRelativeError, where M <= 5 d.
inline double plainDistance(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b) {
  static_assert(EdgeDistances::kRelativeError >= (1 + 1e-5) * (5 * errorOf(4) * kRoot2 + errorOf(2)));
  const auto map = [](const Pose& pose, const Vec2& p) {
    return load2(pose.data()) * p.x() + load2(pose.data() + 3) * p.y();
  };
  const Double2 shift = load2(pose_b.data() + 6) - load2(pose_a.data() + 6), apart = absolute(shift);
  const Double2 way = map(pose_b, b.origin) + shift - map(pose_a, a.origin), squares = way * way;
  const double square = squares[0] + squares[1], size = a.extent + b.extent + (apart[0] + apart[1]);
  const double distance = std::sqrt(square);
  return square > 0x1p-900 && square < 0x1p900 && size < 4.9 * distance ? distance : -1;
}

}  // namespace tricover::detail
