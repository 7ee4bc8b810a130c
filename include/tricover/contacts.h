// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "tricover/export.h"
#include "tricover/pair_cache.h"
#include "tricover/polygon.h"
#include "tricover/touching.h"

namespace tricover {

/// Which edges are listed as crossing.
struct CrossingOptions {
  /// A world length, not negative: how far apart two edges may be.
  double margin = 0;
  /// Allowed: with a margin, two edges have to be nearer than it. Without one, of the pairs that share a point those
  /// are listed of which one edge leads on from there, either way, with the interiors of both regions on one of its
  /// sides: where the overlap of the interiors begins. So the list isn't empty if edges meet on the outline of that
  /// overlap, and it is where the interiors are apart.
  Touching touching = Touching::Collides;
};

/// Two edges that share a point, or are within the margin of each other.
struct Crossing {
  EdgeIndex edge_a;  ///< Of a, numbered as in Polygon::edgeStart().
  EdgeIndex edge_b;  ///< Of b, numbered likewise.
  /// In the world, rounded: a common point, of which collinear edges may have others; or, of edges that are apart, the
  /// middle between their nearest points.
  Vec2 point;
};

/// Every pair of edges that are no farther apart than the margin, so that without one they share a point. Edges of
/// length 0 are listed, too. Exact: a pair
/// is listed if and only if it is. The order means nothing. The list is empty where one region lies within the other
/// and no edges are so near.
///
/// Throws as collide() does.
///
/// \snippet contacts.cpp crossings
TRICOVER_EXPORT std::vector<Crossing> crossings(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                                const Pose& pose_b, const CrossingOptions& options = {});

/// What of a contact is worked out, at least. Each costs more than the one before; but of convex polygons all of it
/// costs the least, and of regions that are apart it costs nothing more: there all is told, whatever is asked for.
enum class ContactDetail {
  /// A point, and the edges there, which meet in it; of what lies within the other region a vertex, which only one of
  /// the edges is at. Depth and normal are 0. Costs at most twice crossings(), as a rule.
  Points,
  /// And a depth and a normal, by this part of the overlap and the edges around it as if there were no others: what a
  /// step of a simulation needs, which asks again at the next one. Costs at most four times crossings(), as a rule.
  LocalDepth,
  /// And of an overlap in one part the shortest way apart, whatever stands in the way: for who wants to be free at
  /// once. Costs a penetration().
  GlobalDepth
};

/// What counts as a contact, how many are wanted, and what of them.
struct ContactOptions {
  /// A world length, not negative: a and b are grown by it together, as collide()'s margin says. The regions' overlap
  /// then counts for as much deeper; where they are apart, by d, there is one contact, of the depth margin - d.
  double margin = 0;
  /// How many contacts are returned, the deepest ones.
  std::size_t most = std::numeric_limits<std::size_t>::max();
  ContactDetail detail = ContactDetail::GlobalDepth;  ///< What of each one is told.
  /// Allowed: parts of the overlap without an interior, where the regions only touch, are left out, and with a margin
  /// regions that are exactly so far apart.
  Touching touching = Touching::Collides;
};

/// One connected part of the regions' overlap, in the world. Coordinates are rounded: they are off by at most 128 units
/// of roundoff (2^-53) of the polygons' own coordinates and the poses' translations, added up, and by 2^-1042.
struct Contact {
  /// A point of this part of the overlap, but for rounding: its middle, on the line along the normal through its
  /// deepest point, or, where that is outside, in a notch or a hole, another one. Of regions that are apart, but for a
  /// margin, it is the middle between their nearest points.
  Vec2 point;
  /// A unit vector, from a towards where b leaves it. For two convex polygons moving b along it by `depth` is the
  /// shortest way apart, and so it is wherever the overlap is a single part: they are penetration()'s, unless that
  /// search is given up or, with a margin, isn't optimal. Here it is given up after 2^22 translations divided by the
  /// number of vertices (sooner than there from 210 on, at once beyond 4096). Of several parts, and with LocalDepth, it
  /// takes the edges around this one past each other, or, where one polygon lies within the other, past the nearest
  /// edge: good for a response that is repeated, not for one step. Where they only touch, moving b along it by a little
  /// parts them, unless they are wedged or touch at several parts; with LocalDepth that isn't tried.
  Vec2 normal;
  /// At least 0, and of two convex polygons as precise as coordinates are, however short their edges. It is 0 where
  /// they only touch, and may be 0 where the overlap is thinner than coordinates are rounded, as of regions without
  /// area: penetration() tells. A margin is added to all that.
  double depth;
  EdgeIndex edge_a;  ///< The edge of a that parts last. -1 where this part lies inside a, away from its edges.
  EdgeIndex edge_b;  ///< The edge of b that parts last. -1 where this part lies inside b, away from its edges.
};

/// One contact for each connected part of the overlap, the deepest first; or, where the regions are apart and within
/// the margin, one where they are nearest. Empty exactly where collide() with that margin and touching is false, or
/// `most` is 0.
///
/// Cost of a convex pair: 0.3 us for 8 vertices each, 1 us for 64, twice that where they are deep in each other. Of
/// others, with one part, that of a penetration() more: 15 and 30 us where they overlap by little, 30 and 250 us where
/// by a third of their size; for 1024 vertices up to 0.2 s. It grows with the number of parts, and with that of pairs
/// of edges that meet.
///
/// Throws as collide() does.
///
/// \snippet contacts.cpp contacts
/// \snippet contacts.cpp contacts with margin
TRICOVER_EXPORT std::vector<Contact> contacts(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                              const Pose& pose_b, const ContactOptions& options = {});

/// The same to the last bit, using and renewing the certificate in `cache`: O(1) while they are apart and that fact
/// pays for the motion since.
///
/// \snippet contacts.cpp contacts with cache
TRICOVER_EXPORT std::vector<Contact> contacts(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                              const Pose& pose_b, PairCache& cache, const ContactOptions& options = {});

}  // namespace tricover
