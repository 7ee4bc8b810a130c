// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "hierarchy/hierarchy.h"
#include "hierarchy/placement.h"

namespace tricover::detail {

/// Between squares of lengths: the products and the sum of one, the product of the other and that of a length with a
/// last rounding by itself.
constexpr int kDiscSquares = 2 + 1 + 2;

/// The largest disc known to be inside of a region. A point or segment has one of radius 0 around S, which is on it but
/// for 2U: Placement::kWayError is twice what it must be.
struct InnerDisc {
  explicit InnerDisc(const PolygonData& polygon) {
    if (polygon.isDegenerate()) {
      center = polygon.origin;
      radius = 0;
    } else if (const InnerDiscs* discs = innerDiscsIfBuilt(polygon)) {
      center = discs->center;
      radius = discs->largest > 0 ? discs->largest : -1;  // the centre needn't be in the region
    } else {
      center = polygon.origin;
      radius = -1;
    }
  }

  Vec2 center;
  double radius;  ///< negative if there is none
};

// What the sums of radii round by isn't counted below: kLargestDefect and kWayError pay for it.

/// The gap between the bounding discs, a lower bound of the distance, if it is above the margin; otherwise -1.
inline double gapOfDiscs(const Placement& pair, double margin) {
  const double square = dot(pair.way(), pair.way());
  const double sum = (pair.a.radius + pair.b.radius) * (1 + kLargestDefect) + pair.error(), apart = sum + margin;
  if (!(squarable(apart) && square > roundedUp<kDiscSquares>(apart * apart))) return -1;
  // The root of two roundings and its own; the difference, at most what the root is.
  return square < 0x1p1000 ? roundedDown<3>(std::sqrt(square)) - sum : margin;
}

/// How deep discs inside the two regions overlap, 0 if they are within the margin at least; otherwise -1.
inline double depthOfDiscs(const Placement& pair, double margin) {
  const InnerDisc disc_a(pair.a), disc_b(pair.b);
  if (!(disc_a.radius >= 0 && disc_b.radius >= 0)) return -1;
  const Double2 way = pair.way(disc_a.center, disc_b.center);
  const double square = dot(way, way);
  const double reach = (disc_a.radius + disc_b.radius) * (1 - kLargestDefect) - pair.error(), within = reach + margin;
  if (!(squarable(within) && roundedUp<kDiscSquares>(square) < within * within)) return -1;
  return std::max(roundedDown<2>(reach) - roundedUp<2>(std::sqrt(square)), 0.0);
}

}  // namespace tricover::detail
