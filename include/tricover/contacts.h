// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "tricover/polygon.h"

namespace tricover {

/// Two edges that share a point.
struct Crossing {
  std::ptrdiff_t edge_a;  ///< numbered as in Polygon::edgeStart
  std::ptrdiff_t edge_b;  ///< likewise
  Vec2 point;             ///< world, rounded; of collinear edges that overlap, one common point
};

/// Every pair of edges that share a point, in no order that means anything. Exact: a pair is listed if and only if they
/// do. Empty in a containment.
std::vector<Crossing> crossings(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b);

/// One connected part of the regions' overlap, in the world. Coordinates are rounded: by a few ulps of the polygons'
/// sizes, seen from the smaller one's place.
struct Contact {
  Vec2 point;  ///< the middle of the overlap along the normal, through the deepest point
  /// Unit: moving b along it leaves this part of the overlap. For two convex polygons that is the shortest way apart;
  /// otherwise one that takes the edges around this part past each other, in a containment past the nearest edge.
  Vec2 normal;
  double depth;           ///< >= 0: how far b must move along it; 0 where they only touch
  std::ptrdiff_t edge_a;  ///< whose point parts last; in a containment -1 for the polygon whose inside holds the point
  std::ptrdiff_t edge_b;  ///< likewise of b
};

/// One contact for each connected part of the overlap, deepest first, at most `most`; empty exactly where collide() is
/// false. Throws std::invalid_argument as collide() does.
std::vector<Contact> contacts(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                              std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace tricover
