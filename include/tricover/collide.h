// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tricover/polygon.h"

namespace tricover {

/// How the answer is found. Both give the same answers, from the same predicates, influence areas and edge test.
enum class Strategy {
  Hierarchy,  ///< the default: clearance facts and a hierarchy of influence areas, both polygons descended together
  Paper,  ///< Algorithm 3 as printed, with its repairs: circles, influence mask, extended areas, sign changes; O(n m)
};

/// What is asked of a boolean query. The default: do the regions share a point?
struct CollideOptions {
  /// World length >= 0: "closer than or equal to margin?" Exact, equality included.
  double margin = 0;
  /// World length >= 0: true stays certain wherever the distance is at most margin; above it, true may be answered
  /// only where the distance is at most margin + tolerance.
  double tolerance = 0;
  Strategy strategy = Strategy::Hierarchy;  ///< changes the cost, never the answer
};

/// What one pair of polygons remembers between queries: facts, not state. Each stays true whatever happens in between,
/// so a cache may be copied, shared between calls of other pairs, lost or stale: no answer changes, only its cost.
/// Plain data; PairCache{} is empty. Not to be used by two threads at once.
struct PairCache {
  std::uint64_t first_id = 0;   ///< of the polygons the facts are about, in the kernel's own order (0: none)
  std::uint64_t second_id = 0;  ///< likewise

  /// "With the polygons at these poses (columns of R, then t) the regions did (`overlapping`) or did not overlap, and
  /// that stays so while no point is moved against the other polygon by `clearance` or more", a world length.
  double first_pose[6] = {1, 0, 0, 1, 0, 0};
  double second_pose[6] = {1, 0, 0, 1, 0, 0};  ///< see first_pose
  double clearance = 0;                        ///< see first_pose
  bool overlapping = false;                    ///< see first_pose
  std::uint32_t uses = 0;  ///< queries answered since: their mean motion sets how far the next fact looks ahead

  /// The edges that answered the last hit, -1 if none did: tried first at the next pose.
  std::int64_t first_edge = -1;
  std::int64_t second_edge = -1;  ///< see first_edge

  /// Strategy::Paper only: the moving centroid's side of every edge of the first polygon, two bits each, when it was
  /// last outside every influence area and the regions were apart. Empty if they weren't.
  std::vector<std::uint64_t> mask;
};

/// Whether the two closed regions share a point (or, with a margin, come at least that close). Exact for every finite
/// input; independent of argument order, history and thread. O(log n + log m + k) typical, k the edge pairs in reach.
/// Throws std::invalid_argument for a pose that is not finite or not rigid within kRigidTolerance, and for a margin or
/// tolerance that is negative or not finite.
bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
             const CollideOptions& options = {});

/// The same answer, using and renewing the facts in `cache`; O(1) while a fact pays for the motion since it was found.
bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, PairCache& cache,
             const CollideOptions& options = {});

}  // namespace tricover
