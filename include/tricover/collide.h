// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "tricover/export.h"
#include "tricover/polygon.h"

namespace tricover {

/// What is asked of a boolean query. The default: do the regions share a point?
struct CollideOptions {
  /// A world length, at least 0. The question becomes "is the distance at most margin?". Exact, equality included.
  double margin = 0;
  /// A world length, at least 0, that buys time. Up to a distance of margin the answer is true, as ever. Above margin +
  /// tolerance it is false. In between it may be either.
  double tolerance = 0;
};

/// What one pair of polygons remembers between queries: facts, not state. Each stays true whatever happens in between,
/// so a cache may be copied, shared between calls of other pairs, lost or stale: no answer changes, only its cost.
///
/// A value to be copied and moved like any other; PairCache{} is empty. Not to be used by two threads at once. It is of
/// no use to another process, nor to this program when it runs again: Polygon::id() starts anew, so that a cache that
/// was written to a file would be taken for one of other polygons. Don't keep one longer than the process lives.
struct PairCache {
  std::uint64_t first_id = 0;   ///< of the polygons the facts are about, in the kernel's own order (0: none)
  std::uint64_t second_id = 0;  ///< likewise

  /// "With the polygons at these poses (columns of R, then t) the answer was `overlapping`, and whether the regions
  /// overlap stays so while no point is moved against the other polygon by `clearance`, a world length, or more." A hit
  /// by the margin or the tolerance alone is kept as overlapping, too, with a clearance of 0, by which nothing stays
  /// so.
  double first_pose[6] = {1, 0, 0, 1, 0, 0};
  double second_pose[6] = {1, 0, 0, 1, 0, 0};  ///< see first_pose
  double clearance = 0;                        ///< see first_pose
  bool overlapping = false;                    ///< see first_pose
  std::uint32_t uses = 0;  ///< queries answered since: their mean motion sets how far the next fact looks ahead

  /// The edges that answered the last hit, or the vertices next to the line that was found between two convex polygons
  /// (as the kernel numbers both), -1 if none did: tried first at the next pose.
  std::int64_t first_edge = -1;
  std::int64_t second_edge = -1;  ///< see first_edge
};

/// Whether the two closed regions share a point or, with a margin, come at least that close.
///
/// Exact for every finite input. The answer depends neither on the order of the arguments nor on earlier calls nor on
/// the thread. Typical cost: O(log n + log m + k), where k counts the pairs of edges in reach of each other.
///
/// Throws std::invalid_argument for a pose that is not finite or not rigid within kRigidTolerance, and for a margin or
/// tolerance that is negative or not finite. The first query of a polygon that comes near it builds its hierarchy,
/// which throws std::length_error for more than 2^29 vertices.
///
/// \snippet collide.cpp collide
TRICOVER_EXPORT bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                             const CollideOptions& options = {});

/// The same answer, using and renewing the facts in `cache`. O(1) while the fact in it pays for the motion since.
///
/// \snippet collide.cpp collide with cache
TRICOVER_EXPORT bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                             PairCache& cache, const CollideOptions& options = {});

}  // namespace tricover
