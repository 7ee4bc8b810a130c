// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "tricover/export.h"
#include "tricover/polygon.h"

namespace tricover {

/// Where a ray first meets a polygon's region, in the world.
struct RayHit {
  double fraction;  ///< Of the way from `from` to `to`, from 0 to 1: right to 1e-14.
  Vec2 point;       ///< from + fraction (to - from), rounded.
  /// A unit vector at right angles to the edge, against the ray. Along an edge, and where the ray starts inside the
  /// region, against the ray's direction.
  Vec2 normal;
  std::ptrdiff_t
      edge;  ///< The edge that is hit, of several the one of the lowest number. -1 where the ray starts inside.
};

/// The first point of a polygon's region on the closed segment from `from` to `to`, points of the world; or nothing.
///
/// Whether there is one is exact: a ray that grazes a vertex hits it, and one that starts in the region hits it at
/// fraction 0. A ray of length 0 is a point. Typical cost: O(log n + k), where k counts the edges near the ray.
///
/// Throws std::invalid_argument for a point that is not finite and for a pose that checkPose() refuses, and
/// std::length_error as collide() does.
///
/// \snippet ray.cpp ray
TRICOVER_EXPORT std::optional<RayHit> castRay(const Polygon& polygon, const Pose& pose, const Vec2& from,
                                              const Vec2& to);

}  // namespace tricover
