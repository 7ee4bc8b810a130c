// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "tricover/export.h"
#include "tricover/pair_cache.h"
#include "tricover/polygon.h"

namespace tricover {

/// The options of distance(): a margin, and errors that make it faster. By default the distance is exact.
struct DistanceOptions {
  /// A world length, at least 0 and finite: the sum of the margins that the regions are inflated by. The result becomes
  /// max(0, distance - margin). It is 0 exactly where collide() with this margin is true. Points and edges are those of
  /// the regions themselves, also where these are closer than the margin.
  double margin = 0;
  /// The result is at most truth * (1 + relative_error) + absolute_error. It is never below the truth but for rounding.
  /// Whether it is 0 stays exact. With a margin, the truth is what is left of the distance.
  double relative_error = 0;
  double absolute_error = 0;  ///< A world length; see relative_error.
};

/// A distance and where it is attained, in the world. Where the regions collide (the margin aside), both points are one
/// common point.
struct DistanceResult {
  double distance;   ///< A world length, less the margin.
  Vec2 point_a;      ///< The point of a nearest to b. Rounded as the coordinates of a posed vertex are.
  Vec2 point_b;      ///< The point of b nearest to a. Rounded likewise.
  EdgeIndex edge_a;  ///< The edge of a that point_a lies on. -1 where a ring of b lies inside a.
  EdgeIndex edge_b;  ///< The edge of b that point_b lies on. -1 where a ring of a lies inside b.
};

/// Returns the distance of the two closed regions.
///
/// It is 0 exactly where collide() is true, with the same margin. Otherwise it is right to 1e-14 of itself and the
/// margin together, or to the smallest double where that is more, and infinity where the distance without the margin
/// overflows. The order of the arguments and earlier calls change nothing.
///
/// \throws std::invalid_argument for a pose that checkPose() refuses, for a margin that is negative or not finite, and
/// for an error that is negative or NaN
///
/// \snippet distance.cpp distance
TRICOVER_EXPORT DistanceResult distance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                                        const DistanceOptions& options = {});

/// Returns the same, and first tests the features that were nearest at the last call with this cache. The distance is
/// the same to the last bit, unless options allow errors. Where several points are equally near, it may return other
/// ones.
///
/// \snippet distance.cpp distance with cache
TRICOVER_EXPORT DistanceResult distance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                                        PairCache& cache, const DistanceOptions& options = {});

/// The distance where it is at most `limit`, a world length, and nothing where it is more: what is farther away isn't
/// looked for, which saves time.
///
/// There is a result wherever the truth is at most the limit, and no result is above it, whatever errors are allowed.
/// With a margin, the truth is what is left of the distance, and is compared by the sum of limit and margin, rounded
/// down.
///
/// \throws std::invalid_argument as distance() does, and for a limit that is negative or NaN
///
/// \snippet distance.cpp distance within
TRICOVER_EXPORT std::optional<DistanceResult> distanceWithin(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                                             const Pose& pose_b, double limit,
                                                             const DistanceOptions& options = {});

/// Returns the same, and uses the cache as distance() does.
///
/// \snippet distance.cpp distance within
TRICOVER_EXPORT std::optional<DistanceResult> distanceWithin(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                                             const Pose& pose_b, double limit, PairCache& cache,
                                                             const DistanceOptions& options = {});

}  // namespace tricover
