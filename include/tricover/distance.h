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
  /// Whether it is 0 stays exact.
  double relative_error = 0;
  double absolute_error = 0;  ///< world length
  /// World length: a distance above it needn't be found; the result is then infinity, the points NaN, the edges -1.
  double limit = std::numeric_limits<double>::infinity();
};

/// World frame. Where the regions collide, both points are one common point.
struct DistanceResult {
  double distance;  ///< world length
  Vec2 point_a;     ///< of a, nearest to b; coordinates are rounded as those of a posed vertex are
  Vec2 point_b;     ///< of b, likewise
  /// The edge point_a lies on (numbered as in Polygon::edgeStart); in a containment -1 for the polygon whose inside
  /// holds the point, which is then the start of the other's edge.
  std::ptrdiff_t edge_a;
  std::ptrdiff_t edge_b;  ///< likewise of b
};

/// What one pair remembers between distance queries: facts, as in PairCache, whose rules are these, too.
/// DistanceCache{} is empty.
struct DistanceCache {
  static constexpr int kMost = 8;  ///< pairs of edges that it has room for

  std::uint64_t first_id = 0;   ///< of the polygons the facts are about, in the kernel's own order (0: none)
  std::uint64_t second_id = 0;  ///< likewise

  /// "With the polygons at these poses (columns of R, then t), of all pairs of edges only the first k ones listed were
  /// nearer to each other than apart[k]", for every k up to `count`; world lengths, in increasing order. Where apart[0]
  /// is positive, the regions didn't overlap.
  double first_pose[6] = {1, 0, 0, 1, 0, 0};
  double second_pose[6] = {1, 0, 0, 1, 0, 0};  ///< see first_pose
  int count = 0;                               ///< see first_pose
  std::uint32_t first_edge[kMost] = {};        ///< positions in the kernel's paths
  std::uint32_t second_edge[kMost] = {};       ///< likewise
  double apart[kMost + 1] = {};                ///< see first_pose
  std::uint32_t uses = 0;  ///< queries answered since: their mean motion sets how far the next fact looks ahead
};

/// The distance of the two closed regions: 0 exactly where collide() is true, otherwise right to 1e-14 of itself
/// (nearer the smallest double: to that; infinity where it overflows). Exact for every finite input; symmetric;
/// independent of history. Throws std::invalid_argument as collide() does, and for negative or NaN options.
DistanceResult distance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                        const DistanceOptions& options = {});

/// The same distance, to the last bit unless options allow errors (of equally near points, others may be found), using
/// and renewing the facts in `cache`; O(1) while the pairs of edges that it lists pay for the motion since.
DistanceResult distance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                        DistanceCache& cache, const DistanceOptions& options = {});

}  // namespace tricover
