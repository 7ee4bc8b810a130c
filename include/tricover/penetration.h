// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "tricover/export.h"
#include "tricover/pair_cache.h"
#include "tricover/polygon.h"
#include "tricover/touching.h"

namespace tricover {

/// The margin, and what counts as an overlap.
struct PenetrationOptions {
  /// A world length, not negative. The translation separates the regions by more than the margin. It exists where they
  /// are within the margin of each other, as collide()'s margin says. The depth of convex polygons that overlap is the
  /// depth without a margin, plus the margin. The depth of regions that are apart by d is at least margin - d.
  double margin = 0;
  /// Allowed: no result where the interiors are apart or, with a margin, where the regions are exactly that far apart.
  /// The result for regions that overlap is the same.
  Touching touching = Touching::Collides;
};

/// The shortest translation of b that parts two overlapping regions, in the world.
struct Penetration {
  /// The length of that translation; at its end they still touch. If not `optimal`, an upper bound of it. Infinity
  /// where lengths or translated poses overflow, or where rounding the coordinates loses the polygons' size: then
  /// translation and points are 0, which means nothing, and the edges -1.
  double depth;
  Vec2 normal;  ///< A unit vector, from a towards where b leaves it.
  /// No shorter translation separates the regions, unless it leads into a slit narrower than the precision of
  /// penetration().
  double lower_bound;
  bool optimal;  ///< Whether depth and lower_bound agree to that precision.
  /// After this translation of b (or its opposite of a) they are proven to be apart, even though adding it to the
  /// pose's translation rounds. It differs from depth * normal by as little as that takes.
  Vec2 translation;
  Vec2 point_a;  ///< The point on a's outline that parts last, where it is now.
  /// The same on b's. If optimal, point_a is point_b + depth * normal, otherwise near it. With a margin, if optimal,
  /// these points are the nearest to each other after the translation, and the margin apart.
  Vec2 point_b;
  EdgeIndex edge_a;  ///< The edge that point_a lies on, numbered as in Polygon::edgeStart().
  EdgeIndex edge_b;  ///< The edge that point_b lies on.
};

/// The shortest translation that parts two overlapping regions, or nothing if they are apart, by more than the margin.
///
/// It is the global one: b may also leave into a hole or a gap. Its depth is 0 where they only touch. Where they are
/// wedged it isn't: a peg exactly as wide as its slot has to leave through the mouth. Swapping the operands gives the
/// same depth and the opposite normal, unless they are the same region at the same place.
///
/// With a margin the translation is proven to separate the regions by more than the margin, and lower_bound bounds the
/// shortest one that does. For pairs that are not convex it may be longer than the shortest: the search finds the
/// shortest translation without a margin and then goes straight on.
///
/// The depth of a convex pair is precise to 1e-15 of itself, as long as it is above 1e-14 of the coordinates. For other
/// pairs the precision is 1e-12 of the smaller radius(), plus 1e-13 of both radii, of the margin and of the distance
/// between the poses' translations.
///
/// A convex pair takes O(n + m): 0.7 us for 8 vertices each, 1.5 us for 64. Other pairs take a search. For 64 vertices
/// each, that typically takes 15 to 40 us where they overlap by little, and 0.2 to 1 ms where they overlap by a third
/// of their size; for 1024 vertices up to 0.2 s. A search ends after 20,000 translations. That happens where outlines
/// are almost parallel over a long interval; then lower_bound bounds the depth from below.
///
/// \throws std::invalid_argument for a pose that checkPose() refuses, for a margin that is negative or not finite, for
/// a value that Touching doesn't have, and for a Polygon::complement(), even where the regions are apart
///
/// \snippet penetration.cpp penetration
TRICOVER_EXPORT std::optional<Penetration> penetration(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                                       const Pose& pose_b, const PenetrationOptions& options = {});

/// The same for two polygons that move by small steps. The search tries the cache's last translation first, and to the
/// precision above the depth is that of penetration() without a cache. If several translations are the shortest, it may
/// return another one. Convex pairs make no use of the cache.
///
/// \snippet penetration.cpp penetration with cache
TRICOVER_EXPORT std::optional<Penetration> penetration(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                                       const Pose& pose_b, PairCache& cache,
                                                       const PenetrationOptions& options = {});

}  // namespace tricover
