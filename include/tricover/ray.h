// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

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
/// \throws std::invalid_argument for a point that is not finite, for a pose that checkPose() refuses, and for a margin
/// that is negative or not finite
///
/// \snippet ray.cpp ray
TRICOVER_EXPORT std::optional<RayHit> castRay(const Polygon& polygon, const Pose& pose, const Vec2& from,
                                              const Vec2& to, const RayOptions& options = {});

/// A part of a ray that is in a polygon's region; a single point where both fractions are equal.
struct RayInterval {
  RayHit begin;  ///< As castRay() reports a hit.
  /// The same for the way back from the ray's end: the last edge on the way, or -1 where the ray ends in the region.
  /// The fraction is the one from the ray's start. The normal points along the ray.
  RayHit end;
};

/// Returns all intervals of the closed segment from `from` to `to` that are in a polygon's region, in order. The first
/// one begins where castRay() hits.
///
/// Without a margin the intervals and their edges are exact: a vertex that the ray grazes is an interval, and an
/// interval runs along edges and over what touches within the region. A ray of length 0 in the region is one interval
/// from 0 to 1. Typical cost: O(log n + k log k), where k counts the edges near the ray's line.
///
/// With a margin, each end is as precise as castRay()'s hit. Two intervals that are less than 1e-9 of the ray apart may
/// be reported as one.
///
/// \throws std::invalid_argument as castRay() does
///
/// \snippet ray.cpp all
TRICOVER_EXPORT std::vector<RayInterval> castRayAll(const Polygon& polygon, const Pose& pose, const Vec2& from,
                                                    const Vec2& to, const RayOptions& options = {});

}  // namespace tricover
