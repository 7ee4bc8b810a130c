// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tricover/export.h"
#include "tricover/pair_cache.h"
#include "tricover/polygon.h"
#include "tricover/touching.h"

namespace tricover {
namespace detail {

/// What the last searches knew about squares of the plane of b's translations: the first nine cells are a square and
/// those around it.
struct SearchHints {
  enum Kind : std::uint8_t { Unknown, Divided, Met, Blocked, Done };
  struct Cell {
    std::uint32_t first = 0;   ///< the first of its four parts; or of two edges that meet on all of it, if any do
    std::uint32_t second = 0;  ///< the other one
    float until = 0;           ///< Done, as far away as that less what `moved` is by then
    Kind kind = Unknown;
  };

  std::uint64_t first_id = 0;  ///< of the polygons, in the kernel's own order (0: none)
  std::uint64_t second_id = 0;
  double first_turn[4] = {1, 0, 0, 1};  ///< R of their poses, by columns
  double second_turn[4] = {1, 0, 0, 1};
  double margin = 0;  ///< in the pair's units, as all lengths here
  double noise = 0;   ///< what places were wrong by
  // Where b's S is from a's, in the world.
  double center[2] = {0, 0};  ///< in the middle of that square
  double place[2] = {0, 0};   ///< when it was asked for last
  double limit[2] = {0, 0};   ///< at the end of the shortest translation, and beside that
  double parting[2] = {0, 0};
  double moved = 0;  ///< in all, since there were hints
  double half = 0;   ///< of the square's side
  std::vector<Cell> cells;
  /// What bounds all that overlaps, likewise, if it isn't much.
  struct Segment {
    double from[2], to[2];
    bool both_sides;
  };
  std::vector<Segment> segments;

  std::uint32_t searches = 0;
  std::uint32_t looks = 0;  ///< cells that a search without hints had to look at
  FactBalance balance;
};

}  // namespace detail

/// What is to be parted, and how much that may cost.
struct PenetrationOptions {
  /// A world length, not negative: a and b are grown by it together, as collide()'s margin says. What they overlap by
  /// then is asked for: after the translation they are the margin apart. Of convex polygons that overlap, the depth is
  /// the margin more; of any that are apart by d, it is at least margin - d.
  double margin = 0;
  /// Not negative: the depth may be larger than that of the shortest way by this share of it, which saves time for
  /// pairs that aren't convex. It is at most (1 + depth_error) lower_bound, but for the precision of penetration().
  /// With infinity nothing is searched: the depth is that of the two convex hulls.
  double depth_error = 0;
  /// Allowed: nothing where the interiors are apart, or, with a margin, where the regions are exactly so far apart. How
  /// those are parted that do overlap is as ever.
  Touching touching = Touching::Collides;
};

/// The shortest translation of b that parts two overlapping regions, in the world.
struct Penetration {
  /// The length of that translation; at its end they still touch. If not `optimal`, an upper bound of it. Infinity
  /// where lengths or translated poses overflow, or where rounding the coordinates loses the polygons' size: then
  /// translation and points are 0, which means nothing, and the edges -1.
  double depth;
  Vec2 normal;  ///< A unit vector, from a towards where b leaves it.
  /// No shorter translation parts them, but one into a slit that is narrower than the precision of penetration().
  double lower_bound;
  bool optimal;  ///< Whether depth and lower_bound agree to that precision.
  /// After this translation of b (or its opposite of a) they are proven to be apart, even though adding it to the
  /// pose's translation rounds. It differs from depth * normal by as little as that takes.
  Vec2 translation;
  Vec2 point_a;  ///< The point on a's outline that parts last, where it is now.
  /// The same on b's. If optimal, point_a is point_b + depth * normal, otherwise near it. With a margin, these are the
  /// points that are nearest to each other after the translation, and the margin apart.
  Vec2 point_b;
  EdgeIndex edge_a;  ///< The edge that point_a lies on, numbered as in Polygon::edgeStart().
  EdgeIndex edge_b;  ///< The edge that point_b lies on.
};

/// The shortest translation that parts two overlapping regions, or nothing if they are apart, by more than the margin.
///
/// It is the global one: b may also leave into a hole or a gap. Its depth is 0 where they only touch. Where they are
/// wedged it isn't: a peg exactly as wide as its slot has to leave through the mouth. Swapping the operands gives the
/// same depth and the opposite normal.
///
/// Precision of a convex pair: 1e-15 of the depth, as long as that is above 1e-14 of the coordinates. Of other pairs:
/// 1e-12 of the smaller radius(), plus 1e-13 of both radii, of the margin and of the distance between the poses'
/// translations.
///
/// Cost of a convex pair: O(n + m); 1.5 us for 8 vertices each, 3 us for 64. Other pairs take a search. For 64 vertices
/// each, that typically takes 15 to 40 us where they overlap by little, and 0.2 to 1 ms where they overlap by a third
/// of their size; for 1024 vertices up to 0.2 s. A search ends after 20,000 translations, as it may be of outlines that
/// are nearly, but not quite, parallel over a long way: then lower_bound says how deep they are at least.
///
/// Throws as collide() does, and for a depth_error that is negative or NaN.
///
/// \snippet penetration.cpp penetration
TRICOVER_EXPORT std::optional<Penetration> penetration(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                                       const Pose& pose_b, const PenetrationOptions& options = {});

/// What one pair of polygons remembers of its last penetrations: where the search for them found nothing, had to look
/// closely, and which edges met. What a turn may change is proven anew. So such a cache, like a PairCache, may be
/// copied, another pair's, lost or stale. It isn't part of a PairCache since it grows with what is searched, up to
/// 200 KB.
///
/// PenetrationCache{} is empty. Not to be used by two threads at once, nor to be kept longer than the process lives.
///
/// \snippet penetration.cpp penetration with cache
class PenetrationCache {
 private:
  friend struct detail::CacheAccess;
  detail::SearchHints facts_;
};

/// The same for two polygons that move by small steps: best where they don't turn. To the precision above the depth is
/// that of penetration() without a cache; of several shortest ways it may be another one. Convex pairs make no use of
/// it.
TRICOVER_EXPORT std::optional<Penetration> penetration(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                                       const Pose& pose_b, PenetrationCache& cache,
                                                       const PenetrationOptions& options = {});

}  // namespace tricover
