// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "tricover/export.h"
#include "tricover/polygon.h"

namespace tricover {

/// Two edges that share a point.
struct Crossing {
  std::ptrdiff_t edge_a;  ///< Of a, numbered as in Polygon::edgeStart().
  std::ptrdiff_t edge_b;  ///< Of b, numbered likewise.
  Vec2 point;             ///< A common point, in the world, rounded. Collinear edges may have others.
};

/// Every pair of edges that share a point. Exact: a pair is listed if and only if it does. The order means nothing. The
/// list is empty where one region lies within the other and no edges touch.
///
/// Throws as collide() does.
///
/// \snippet contacts.cpp crossings
TRICOVER_EXPORT std::vector<Crossing> crossings(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                                const Pose& pose_b);

/// One connected part of the regions' overlap, in the world. Coordinates are rounded, by a few ulps of the polygons'
/// sizes.
struct Contact {
  /// The middle of this part of the overlap, on the line along the normal through its deepest point.
  Vec2 point;
  /// A unit vector. Moving b along it by `depth` clears this part of the overlap. For two convex polygons it is the
  /// shortest way apart. Otherwise it takes the edges around this part past each other, or, where one polygon lies
  /// within the other, past the nearest edge.
  Vec2 normal;
  double depth;           ///< At least 0. It is 0 where they only touch.
  std::ptrdiff_t edge_a;  ///< The edge of a that parts last. -1 where this part lies inside a, away from its edges.
  std::ptrdiff_t edge_b;  ///< The edge of b that parts last. -1 where this part lies inside b, away from its edges.
};

/// One contact for each connected part of the overlap, the deepest first, at most `most`. Empty exactly where collide()
/// is false.
///
/// Throws as collide() does.
///
/// \snippet contacts.cpp contacts
TRICOVER_EXPORT std::vector<Contact> contacts(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                              const Pose& pose_b,
                                              std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace tricover
