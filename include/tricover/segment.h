// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/export.h"
#include "tricover/polygon.h"

namespace tricover {

/// The polygon that is this point and nothing else: one ring of three equal vertices. With a margin of r it is an exact
/// closed disc of radius r, in every query that takes a margin. Distances and impacts name its edge 0.
///
/// \throws std::invalid_argument for a coordinate that is not finite
///
/// \snippet segment.cpp point
TRICOVER_EXPORT Polygon point(const Vec2& p);

/// The polygon that is the closed segment from p to q (their frame is the polygon's) and nothing else: one ring of p,
/// q and q once more. With a margin of r it is an exact stadium: every point within r of the segment. Distances and
/// impacts name its edge 0, from p to q. If p and q are equal, it is that point.
///
/// \throws std::invalid_argument for a coordinate that is not finite
///
/// \snippet segment.cpp segment
TRICOVER_EXPORT Polygon segment(const Vec2& p, const Vec2& q);

/// Returns the rectangle of that width, along x, and height, along y, around the origin of its frame.
///
/// \throws std::invalid_argument for a length that is not finite and positive
///
/// \snippet segment.cpp box
TRICOVER_EXPORT Polygon box(double width, double height);

}  // namespace tricover
