// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "tricover/polygon.h"

namespace tricover {

/// What a distance may be wrong by, and from where on it is of no interest. The default is exact.
struct DistanceOptions {
  /// The result is at most truth * (1 + relative_error) + absolute_error, and never below the truth but for rounding.
  double relative_error = 0;
  double absolute_error = 0;  ///< world length
  /// World length: a distance above it needn't be found; the result is then infinity, without points.
  double limit = std::numeric_limits<double>::infinity();
};

/// World frame. Where the regions collide, both points are one common point.
struct DistanceResult {
  double distance;
  Vec2 point_a, point_b;  ///< nearest points of a and b, rounded
  /// The edges they lie on (numbered as in Polygon::edgeStart); in a containment -1 for the polygon whose inside holds
  /// the point.
  std::ptrdiff_t edge_a, edge_b;
};

/// What one pair remembers between distance queries: facts, as in PairCache, whose rules are these, too. DistanceCache{}
/// is empty.
struct DistanceCache {
  static constexpr int kMost = 8;

  std::uint64_t first_id = 0, second_id = 0;
  double first_pose[6] = {1, 0, 0, 1, 0, 0}, second_pose[6] = {1, 0, 0, 1, 0, 0};

  /// "With the polygons at these poses all pairs of edges but the `count` ones listed were farther apart than `beyond`",
  /// a world length, and the regions didn't overlap.
  double beyond = 0;
  int count = 0;
  std::uint32_t first_edge[kMost] = {}, second_edge[kMost] = {};
  std::uint32_t uses = 0;  ///< queries answered since: their mean motion sets how far the next fact looks ahead
};

/// The distance of the two closed regions: 0 exactly where collide() is true, otherwise right to 1e-14 of itself
/// (nearer the smallest double: to that; infinity where it overflows). Exact for every finite input; symmetric;
/// independent of history. Throws std::invalid_argument as collide() does, and for negative or NaN options.
DistanceResult distance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                        const DistanceOptions& options = {});

/// The same distance (of equally near points, others may be found), using and renewing the facts in `cache`.
DistanceResult distance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                        DistanceCache& cache, const DistanceOptions& options = {});

}  // namespace tricover
