// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <type_traits>

#include "tricover/export.h"

namespace tricover {
namespace detail {

struct CacheAccess;

/// Whether a cache's facts pay: what they have saved lately beyond what they cost.
struct FactBalance {
  std::int8_t saved = 16;    ///< in quarters of a query; a new cache may try some
  std::uint8_t failed = 0;   ///< how often in a row they cost more
  std::uint8_t resting = 0;  ///< so many queries more do without facts
};

/// "With the polygons at these poses (columns of R, then t) the answer was `overlapping`, and whether the regions
/// overlap stays so while no point is moved against the other polygon by `clearance`, a world length, or more." A hit
/// by the margin or the tolerance alone is kept as overlapping, too, with a clearance of 0, by which nothing stays so.
struct CollisionFact {
  std::uint64_t first_id = 0;   ///< of the polygons, in the kernel's own order (0: none)
  std::uint64_t second_id = 0;  ///< likewise
  double first_pose[6] = {1, 0, 0, 1, 0, 0};
  double second_pose[6] = {1, 0, 0, 1, 0, 0};
  double clearance = 0;
  bool overlapping = false;
  std::int8_t cost = 0;  ///< of finding it, beside the answer, in quarters of a query
  FactBalance balance;
  std::uint32_t uses = 0;  ///< queries answered since: their mean motion sets how far the next fact looks ahead
  float looked_ahead = 0;  ///< the last clearance that was found, kept while facts rest

  /// The edges that answered the last hit, or those that are or start with the nearest features of two convex polygons
  /// (as the kernel numbers both), -1 if there were none: tried first at the next pose.
  std::int64_t first_edge = -1;
  std::int64_t second_edge = -1;
};

/// "When the polygons were at these poses, of all pairs of edges only the first k ones listed here were nearer to each
/// other than apart[k]": for every k from 0 to count.
struct DistanceFacts {
  static constexpr int kMost = 8;  ///< how many pairs of edges it has room for

  std::uint64_t first_id = 0;
  std::uint64_t second_id = 0;
  double first_pose[6] = {1, 0, 0, 1, 0, 0};
  double second_pose[6] = {1, 0, 0, 1, 0, 0};
  int count = 0;
  std::uint32_t first_edge[kMost] = {};
  std::uint32_t second_edge[kMost] = {};
  double apart[kMost + 1] = {};  ///< world lengths, increasing; if apart[0] is positive, the regions didn't overlap
  std::uint32_t uses = 0;

  // What only saves time.
  std::uint8_t hint = 0;      ///< where to look first, by the first pair of edges in the lists above; 0: nothing
  std::uint8_t answered = 0;  ///< queries that the facts have answered since they were found, if they looked ahead
  FactBalance balance;
};

/// "With the second polygon at this pose in the first one's frame, the other polygon reached at least `deeper` behind
/// every edge but those listed here."
struct ContactFacts {
  static constexpr int kMost = 4;  ///< how many edges it has room for

  std::uint64_t first_id = 0;
  std::uint64_t second_id = 0;
  double second_in_first[6] = {1, 0, 0, 1, 0, 0};
  double error = 0;   ///< what that maps points wrong by, at most
  double deeper = 0;  ///< a length in the first one's frame
  std::uint8_t count = 0;
  FactBalance balance;
  bool of_first[kMost] = {};         ///< whether an edge is the first polygon's
  std::uint32_t face[kMost] = {};    ///< the edges, as the kernel numbers them
  std::uint32_t behind[kMost] = {};  ///< an edge of the other polygon at its vertex that was deepest behind them
};

struct PairFacts {
  CollisionFact collision;
  DistanceFacts distance;
  ContactFacts contact;
};

}  // namespace detail

/// What one pair of polygons remembers between queries, of whatever kind: facts, not state. Each stays true whatever
/// happens in between, and names the polygons and poses that it is about. So a cache may be copied, shared between
/// calls of other pairs, lost or stale: no answer changes, only its cost.
///
/// A value of 544 bytes, to be copied like any other; PairCache{} is empty. Not to be used by two threads at once. It
/// is of no use to another process, nor to this program when it runs again: Polygon::id() starts anew, so that a cache
/// that was written to a file would be taken for one of other polygons. Don't keep one longer than the process lives.
///
/// \snippet collide.cpp collide with cache
class PairCache {
 private:
  friend struct detail::CacheAccess;
  detail::PairFacts facts_;
};

static_assert(std::is_trivially_copyable_v<PairCache>);

}  // namespace tricover
