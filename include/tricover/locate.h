// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "tricover/export.h"
#include "tricover/pair_cache.h"
#include "tricover/polygon.h"

namespace tricover {

/// Where a point is. A point of an edge is Boundary even where the region lies on both of the edge's sides.
enum class Location { Outside, Boundary, Inside };

namespace detail {

struct CacheAccess;

/// "The point was here, and so far, at the least, from all edges."
struct PointFact {
  std::uint64_t polygon_id = 0;  ///< Polygon::id() of the polygon that the fact is about; 0: none
  Location location = Location::Outside;
  double point[2] = {0, 0};  ///< in the polygon's frame
  double clearance = 0;
  std::uint32_t uses = 0;  ///< queries answered since
  FactBalance balance;
};

}  // namespace detail

/// Where `point`, in the polygon's own frame, lies. Exact for every finite point.
///
/// This is the paper's Algorithm 1: the signs of the covering triangles that hold the point are summed, and the
/// polygon's fill rule says what the sum means. The first few points ask all edges, O(n); then a hierarchy is built,
/// and typically it takes O(log n + k), where k counts the edges near a ray from the point.
///
/// Throws std::invalid_argument for a point that is not finite, and std::length_error as collide() does.
///
/// \snippet locate.cpp locate
TRICOVER_EXPORT Location locate(const Polygon& polygon, const Vec2& point);

/// What a moving point keeps between calls: a fact, as in a PairCache, with the same rules. It may serve another
/// polygon from call to call.
///
/// \snippet locate.cpp locate with cache
class PointCache {
 private:
  friend struct detail::CacheAccess;
  detail::PointFact facts_;
};

/// The same answer, with coherence. The location changes at edges alone: while the point has moved by less than it was
/// away from them, the inclusion test is skipped. (The paper's Algorithm 2 compares the signs against all edges' lines
/// instead, which costs O(n) a call and is left behind as soon as the point crosses any of them.)
///
/// \snippet locate.cpp locate with cache
TRICOVER_EXPORT Location locate(const Polygon& polygon, const Vec2& point, PointCache& cache);

}  // namespace tricover
