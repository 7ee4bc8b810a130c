// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "tricover/export.h"
#include "tricover/polygon.h"

namespace tricover {

/// The options of castRay().
struct RayOptions {
  /// A world length, at least 0 and finite. The ray is cast at the region inflated by it.
  double margin = 0;
};

/// Where a ray first meets a polygon's region, in the world.
struct RayHit {
  /// The share of the segment before the hit, from 0 to 1, to a precision of 1e-14. On a segment that ends far beyond
  /// the polygon the fraction makes the point precise to 1e-13 of the polygon's diameter plus its distance from `from`,
  /// unless the fraction is below 1e-300.
  double fraction;
  Vec2 point;  ///< from + fraction (to - from), rounded.
  /// A unit vector at right angles to the edge, against the ray. Where the ray runs along the edge or starts in the
  /// region, and at an edge without length, the ray's direction turned round; of a ray of length 0 the zero vector.
  Vec2 normal;
  /// The first edge on the way, of several that are met at the same point the one of the lowest number: exact. -1 where
  /// the ray starts in the region, its boundary included.
  EdgeIndex edge;
};

/// The first point of a polygon's region on the closed segment from `from` to `to`, points of the world; or nothing.
///
/// Whether there is one is exact: a ray that grazes a vertex hits it, and one that starts in the region hits it at
/// fraction 0. A ray of length 0 is a point. Typical cost: O(log n + k), where k counts the edges near the ray.
///
/// With a margin, the grown region is met within 1e-13 of the coordinates, as timeOfImpact() meets it. The hit's edge
/// is then the one that the margin is around, and its normal leads from there to the hit.
///
/// Throws std::invalid_argument for a point that is not finite, for a pose that checkPose() refuses and a margin that
/// is negative or not finite, and std::length_error as collide() does.
///
/// \snippet ray.cpp ray
TRICOVER_EXPORT std::optional<RayHit> castRay(const Polygon& polygon, const Pose& pose, const Vec2& from,
                                              const Vec2& to, const RayOptions& options = {});

}  // namespace tricover
