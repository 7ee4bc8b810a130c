// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
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
  /// If Allowed, two edges are listed with a margin if they are nearer than the margin. Without one, a pair that shares
  /// a point is listed only if both interiors lie on the same side of one of its edges next to that point: there the
  /// overlap of the interiors begins. The list is not empty if edges meet on the outline of that overlap, and
  /// empty if the interiors are apart.
  Touching touching = Touching::Collides;
};

/// Two edges that share a point, or are within the margin of each other.
struct Crossing {
  EdgeIndex edge_a;  ///< An edge of a, numbered as in Polygon::edgeStart().
  EdgeIndex edge_b;  ///< An edge of b, numbered likewise.
  /// In the world, rounded: a common point (collinear edges may have others) or, for edges that are apart, the middle
  /// between their nearest points.
  Vec2 point;
};

/// Returns every pair of edges that are no farther apart than the margin; without one, every pair that shares a point.
/// This is exact, and edges of length 0 are listed, too. The order means nothing. The list is empty where one region
/// lies within the other and no edges are that near.
///
/// \throws std::invalid_argument for a pose that checkPose() refuses, for a margin that is negative or not finite, and
/// for a value that Touching doesn't have
///
/// \snippet contacts.cpp crossings
TRICOVER_EXPORT std::vector<Crossing> crossings(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                                const Pose& pose_b, const CrossingOptions& options = {});

/// How much of a contact is computed, at least. Each level costs more than the one before. Convex polygons, and regions
/// that are apart, get everything at any level, since it costs no more there.
enum class ContactDetail {
  /// A point and the two edges that meet in it or, for a ring inside the other region, a vertex with its edge. Depth
  /// and normal are 0. Takes at most twice as long as crossings(), as a rule.
  Points,
  /// Also a depth and a normal, from the outlines around this component of the overlap as if there were no others. A
  /// simulation, which computes contacts anew at each step, needs no more. Takes six to nine times as long as
  /// crossings() where the overlap is shallow, and thirty to forty times where it is deep.
  LocalDepth,
  /// Also, if the overlap is one component, the shortest translation that separates the regions, for callers that want
  /// to be free at once. Takes as long as penetration().
  GlobalDepth
};

/// The options of contacts().
struct ContactOptions {
  /// A world length, not negative: a and b are grown by it together, as collide()'s margin says. The regions' overlap
  /// then counts for as much deeper; where they are apart, by d, there is one contact, of the depth margin - d.
  double margin = 0;
  /// How many contacts are returned, the deepest ones.
  std::size_t most = std::numeric_limits<std::size_t>::max();
  ContactDetail detail = ContactDetail::LocalDepth;  ///< How much is computed of each one.
  /// Allowed: parts of the overlap where the regions only touch, with no point of either in the interior of the other
  /// one, are left out, and with a margin regions that are exactly so far apart.
  Touching touching = Touching::Collides;
};

/// One of a contact's points, in the world.
struct ContactPoint {
  /// Between the two edges, by the same share as the contact's point, and in the middle of a gap within the margin. At
  /// an acute corner it may lie outside of a region.
  Vec2 point;
  double depth;  ///< At least 0, and no more than the contact's.
};

/// One connected component of the regions' overlap, in the world. Coordinates are rounded: they are off by at most 128
/// units of roundoff (2^-53) of the polygons' own coordinates and the poses' translations, added up, and by 2^-1042.
struct Contact {
  /// A point of this component, but for rounding: the middle of the component on the line along the normal through its
  /// support vertex. Where that middle is outside, in a notch or a hole, it is another point of the component. For
  /// regions that are apart, and within a margin, it is the middle between their nearest points.
  Vec2 point;
  /// A unit vector, from a towards where b leaves it. If both polygons are convex, or the overlap is one component with
  /// GlobalDepth, moving b along it by `depth` is the shortest separating translation, as penetration() finds it. For
  /// polygons that are not convex that search ends after 2^22 translations divided by the number of vertices, and is
  /// left out beyond 4096 vertices. In all other cases the normal separates only this component: moving b along it by
  /// `depth` takes b out of a on every line along it through the component, by the edges around it; where one polygon
  /// lies within the other, it takes b past the nearest edge. Into one wall of a room by t that is t along the wall's
  /// normal, and into both walls of a right-angled corner 1.41 t along the bisector. Use it in a loop that moves and
  /// queries again: one step may not separate them. Where regions only touch, moving b along the normal by a little
  /// separates them, unless they are wedged or touch at several components. LocalDepth does not promise that.
  Vec2 normal;
  /// At least 0. For two convex polygons it is as precise as coordinates are, however short their edges. It is 0 where
  /// regions only touch, and may be 0 where the overlap is thinner than the rounding of coordinates, as for regions
  /// without area; penetration() is precise there, too. A margin is added to the depth.
  double depth;
  EdgeIndex edge_a;  ///< The edge of a that separates last. -1 where this component lies inside a, away from its edges.
  EdgeIndex edge_b;  ///< The edge of b that separates last. -1 where this component lies inside b, away from its edges.
  /// Two points where edge_a and edge_b, with the edges that go straight on from them, face each other along an
  /// interval within the depth: the ends of that interval, the deeper one first, each with the depth along the normal
  /// there. The first has the contact's depth. A crate that rests on a floor has them at its corners: a physics
  /// step, a gripper or a docking check needs both. Otherwise, as for a corner on an edge or with Points, one: `point`
  /// and `depth`.
  std::array<ContactPoint, 2> points;
  std::size_t count;  ///< Of `points`: 1 or 2. The second repeats the first where there is one.
};

/// Returns one contact for each connected component of the overlap, the deepest first. Where the regions are apart and
/// within the margin, it returns one contact where they are nearest. The result is empty exactly where collide() with
/// that margin and touching is false, or `most` is 0.
///
/// A convex pair takes 0.3 us for 8 vertices each and 1 us for 64, twice that where they are deep in each other.
/// With GlobalDepth another pair with one component takes a penetration() more: 15 and 30 us where they overlap by
/// little, 30 and 250 us where by a third of their size; for 1024 vertices up to 0.2 s. The time grows with the number
/// of components and of pairs of edges that meet.
///
/// \throws std::invalid_argument for a pose that checkPose() refuses, for a margin that is negative or not finite, for
/// a value that Touching or ContactDetail doesn't have, and for a Polygon::complement() with GlobalDepth, even
/// where the regions are apart
///
/// \snippet contacts.cpp contacts
/// \snippet contacts.cpp contacts with margin
TRICOVER_EXPORT std::vector<Contact> contacts(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                              const Pose& pose_b, const ContactOptions& options = {});

/// Returns the same to the last bit, and uses and renews the certificate in `cache`. O(1) while the regions are apart
/// and the certificate pays for the motion since.
///
/// \snippet contacts.cpp contacts with cache
TRICOVER_EXPORT std::vector<Contact> contacts(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                              const Pose& pose_b, PairCache& cache, const ContactOptions& options = {});

}  // namespace tricover
