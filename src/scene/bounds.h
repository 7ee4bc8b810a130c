// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>

#include "hierarchy/axis_boxes.h"
#include "numbers/double2.h"
#include "numbers/rounding.h"
#include "polygon/polygon_data.h"
#include "tricover/pose.h"

namespace tricover::detail {

/// Whether a polygon's vertices are asked for its bounds; otherwise its hierarchy is, and built, and they are wider.
inline bool hasFewVertices(const PolygonData& polygon) { return polygon.path.size() <= 400; }

/// A box, grown; without ends where that overflows.
inline Bounds grownBox(Double2 low, Double2 high, Double2 grow) {
  constexpr double kMost = std::numeric_limits<double>::max(), kInfinity = std::numeric_limits<double>::infinity();
  low = low - grow, high = high + grow;
  Bounds bounds = Bounds::between(low, high);
  const unsigned finite = bitsOf(absolute(low) <= kMost) & bitsOf(absolute(high) <= kMost);
  if (finite == 3) return bounds;
  if ((finite & 1) == 0) bounds.min_x = -kInfinity, bounds.max_x = kInfinity;
  if ((finite & 2) == 0) bounds.min_y = -kInfinity, bounds.max_y = kInfinity;
  return bounds;
}

/// A box around all points within `reach` of a disc. By U round the sum, a difference, of the centre and the half, and
/// what half is made of.
inline Bounds boundsOfDisc(Double2 center, double radius, double reach) {
  return grownBox(center, center, absolute(center) * errorOf(2) + roundedUp<4>(radius + reach));
}

/// A box around all points that are within `reach` of the posed polygon, rounded outwards. It never holds NaN.
Bounds boundsOf(const PolygonData& polygon, const Pose& pose, double reach);
/// The same around one edge, by its position.
Bounds boundsOfEdge(const PolygonData& polygon, std::size_t edge, const Pose& pose, double reach);

}  // namespace tricover::detail
