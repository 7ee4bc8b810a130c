// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/distance.h"
#include "tricover/export.h"
#include "tricover/polygon.h"

namespace tricover {

/// The distance of two regions, or how deep they are in each other, in the world.
struct SignedDistance {
  double distance;   ///< A world length, less the margin. Minus the penetration depth where they overlap.
  Vec2 normal;       ///< A unit vector from a to b: moving b along it increases the distance.
  Vec2 point_a;      ///< The point of a nearest to b or, of regions that overlap, that is separated last.
  Vec2 point_b;      ///< The same point of b. `point_b` is near point_a + distance * normal, without a margin.
  EdgeIndex edge_a;  ///< The edge of a that point_a lies on.
  EdgeIndex edge_b;  ///< The edge of b that point_b lies on.
};

/// Returns the distance of two closed regions where they are apart, and minus the depth of their penetration() where
/// they overlap. It is 0 where they only touch, unless they are wedged as penetration() says. The margin is subtracted
/// from either.
///
/// The result is positive exactly where collide() with the same margin is false. The distance is as precise as that of
/// distance(), with the same errors allowed, and the depth as that of penetration(). The result is minus infinity where
/// penetration() has no answer. Swapping the operands turns the normal round and swaps the points, unless they are the
/// same region at the same place.
///
/// \throws std::invalid_argument for a pose that checkPose() refuses, for a margin that is negative or not finite, and
/// for an error that is negative or NaN
///
/// \snippet penetration.cpp signed distance
TRICOVER_EXPORT SignedDistance signedDistance(const Polygon& a, const Pose& pose_a, const Polygon& b,
                                              const Pose& pose_b, const DistanceOptions& options = {});

}  // namespace tricover
