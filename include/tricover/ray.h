// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "tricover/export.h"
#include "tricover/polygon.h"
#include "tricover/ray_hit.h"

namespace tricover {

/// The options of castRay().
struct RayOptions {
  /// A world length, at least 0 and finite. The ray is cast at the region inflated by it.
  double margin = 0;
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
