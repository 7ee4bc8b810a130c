// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/polygon.h"

namespace tricover {

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

/// A part of a ray that is in a polygon's region; a single point where both fractions are equal.
struct RayInterval {
  RayHit begin;  ///< As castRay() reports a hit.
  /// The same for the way back from the ray's end: the last edge on the way, or -1 where the ray ends in the region.
  /// The fraction is the one from the ray's start. The normal points along the ray.
  RayHit end;
};

}  // namespace tricover
