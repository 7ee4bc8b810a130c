// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "tricover/export.h"
#include "tricover/pair_cache.h"
#include "tricover/polygon.h"

namespace tricover {

/// Two edges that share a point.
struct Crossing {
  EdgeIndex edge_a;  ///< Of a, numbered as in Polygon::edgeStart().
  EdgeIndex edge_b;  ///< Of b, numbered likewise.
  Vec2 point;        ///< A common point, in the world, rounded. Collinear edges may have others.
};

/// Every pair of edges that share a point. Exact: a pair is listed if and only if it does. The order means nothing. The
/// list is empty where one region lies within the other and no edges touch.
///
/// Throws as collide() does.
///
/// \snippet contacts.cpp crossings
TRICOVER_EXPORT std::vector<Crossing> crossings(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                                const Pose& pose_b);

/// One connected part of the regions' overlap, in the world. Coordinates are rounded: they are off by at most 128 units
/// of roundoff (2^-53) of the polygons' own coordinates and the poses' translations, added up, and by 2^-1042.
struct Contact {
  /// A point of this part of the overlap, but for rounding: its middle, on the line along the normal through its
  /// deepest point, or, where that is outside, in a notch or a hole, another one.
  Vec2 point;
  /// A unit vector. For two convex polygons moving b along it by `depth` is the shortest way apart, and so it is
  /// wherever the overlap is a single part: they are penetration()'s, unless that exhausts its budget, which here is at
  /// most 2^22 translations divided by the number of vertices (less than the default from 210 on, and none beyond
  /// 4096). Of several parts it takes the edges around this one past each other, or, where one polygon lies within the
  /// other, past the nearest edge: good for a response that is repeated, not for one step. Where they only touch,
  /// moving b along it by a little parts them, unless they are wedged or touch at several parts.
  Vec2 normal;
  /// At least 0, and of two convex polygons as precise as coordinates are, however short their edges. It is 0 where
  /// they only touch, and may be 0 where the overlap is thinner than coordinates are rounded, as of regions without
  /// area: penetration() tells.
  double depth;
  EdgeIndex edge_a;  ///< The edge of a that parts last. -1 where this part lies inside a, away from its edges.
  EdgeIndex edge_b;  ///< The edge of b that parts last. -1 where this part lies inside b, away from its edges.
};

/// One contact for each connected part of the overlap, the deepest first, at most `most`. Empty exactly where collide()
/// is false.
///
/// Cost of a convex pair whose edges cross twice: 0.3 us for 8 vertices each, 1 us for 64; of other convex ones 3 and
/// 12 us. Of others, with one part, that of a penetration() more: 15 and 30 us where they overlap by little, 30 and 250
/// us where by a third of their size; for 1024 vertices up to 0.2 s. It grows with the number of parts, and with that
/// of pairs of edges that meet.
///
/// Throws as collide() does.
///
/// \snippet contacts.cpp contacts
TRICOVER_EXPORT std::vector<Contact> contacts(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                              const Pose& pose_b,
                                              std::size_t most = std::numeric_limits<std::size_t>::max());

/// The same to the last bit, using and renewing the facts in `cache`: O(1) while they are apart and that fact pays for
/// the motion since.
///
/// \snippet contacts.cpp contacts with cache
TRICOVER_EXPORT std::vector<Contact> contacts(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                              const Pose& pose_b, PairCache& cache,
                                              std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace tricover
