// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/export.h"
#include "tricover/pair_cache.h"
#include "tricover/polygon.h"
#include "tricover/touching.h"

namespace tricover {

/// What is asked of a boolean query. The default: do the regions share a point?
struct CollideOptions {
  /// A world length, at least 0. The question becomes "is the distance at most margin?". Exact, equality included.
  double margin = 0;
  /// A world length, at least 0, that buys time. Up to a distance of margin the answer is true, as ever. Above margin +
  /// tolerance it is false. In between it may be either.
  double tolerance = 0;
  /// Allowed: what only touches doesn't collide. The question becomes "do the interiors meet?" or, with a margin, "is
  /// the distance below margin?". Exact, too; with a tolerance touching is within it, so that it may be either.
  Touching touching = Touching::Collides;
};

/// Whether the two closed regions share a point or, with a margin, come at least that close.
///
/// Exact for every finite input. The answer depends neither on the order of the arguments nor on earlier calls nor on
/// the thread. Typical cost: O(log n + log m + k), where k counts pairs of edges in reach and rings that begin near.
///
/// Throws std::invalid_argument for a pose that is not finite or not rigid within kRigidTolerance, and for a margin or
/// tolerance that is negative or not finite, and for a value that Touching doesn't have. The first query of a polygon
/// that comes near it builds its hierarchy, which throws std::length_error for more than 2^29 vertices.
///
/// \snippet collide.cpp collide
/// \snippet collide.cpp touching
TRICOVER_EXPORT bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                             const CollideOptions& options = {});

/// The same answer, using and renewing the facts in `cache`. O(1) while the fact in it pays for the motion since.
///
/// \snippet collide.cpp collide with cache
TRICOVER_EXPORT bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                             PairCache& cache, const CollideOptions& options = {});

}  // namespace tricover
