// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/distance.h"
#include "tricover/export.h"
#include "tricover/polygon.h"

namespace tricover {

/// The distance of two regions, or how deep they are in each other, in the world.
struct SignedDistance {
  double distance;  ///< A world length, less the margin. Minus the depth where they overlap.
  Vec2 normal;      ///< A unit vector from a to b: moving b along it increases the distance.
  Vec2 point_a;     ///< The point of a nearest to b or, of regions that overlap, that of depth().
  Vec2 point_b;     ///< The same point of b. `point_b` is near point_a + distance * normal, without a margin.
  /// The edge of a that point_a lies on; where the regions only touch, one that faces b, or goes straight on to
  /// point_a.
  EdgeIndex edge_a;
  EdgeIndex edge_b;  ///< The edge of b likewise.
};

/// Returns the distance of two closed regions where they are apart, and minus their depth() where they overlap. It is 0
/// where they only touch, and minus infinity for two complements. The margin is subtracted from either.
///
/// collide() with any margin m, negative or not, says whether the signed distance is at most m; with Touching::Allowed,
/// whether it is below m. The distance is as precise as that of distance(), with the same errors allowed, and the depth
/// as that of depth(). How far b must move to be free of a is another question: see penetration(). Swapping the
/// operands turns the normal round and swaps the points, unless they are the same region at the same place.
///
/// \throws std::invalid_argument for a pose that checkPose() refuses, for a margin that is negative or not finite, and
/// for an error that is negative or NaN
///
/// \snippet penetration.cpp signed distance
TRICOVER_EXPORT SignedDistance signedDistance(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                              const Pose& pose_b, const DistanceOptions& options = {});

}  // namespace tricover
