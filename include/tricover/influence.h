// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tricover/export.h"
#include "tricover/polygon.h"

namespace tricover {

/// The influence areas of an edge for a length n >= 0, from the paper's Sections 4 and 5.
enum class InfluenceKind {
  OneSided,  ///< Figure 3: from the edge's line to its parallel at distance n on the outer side, unbounded along it.
  Extended,  ///< Figure 4: within n of the edge's line, on both sides, unbounded along it.
  Bounded,   ///< Figure 9b: Extended, cut by two axis-parallel lines at distance n beyond the vertices.
};

/// Whether `point`, in the polygon's frame, lies in the influence area of `edge` for the given length.
///
/// Extended and Bounded are rounded outwards: they hold every point within n of the edge, so that a point outside of
/// them is proven to be farther away than n. The kernel decides by these two only.
///
/// The outer side of OneSided is that away from S where the edge's covering triangle is positive, and S's own where it
/// is negative. (The paper's text is wrong in concavities and holes.) It is meant for rings that run with the region on
/// their left.
///
/// Throws std::invalid_argument for a length that is negative or NaN and for a point that is not finite, and
/// std::out_of_range for an edge that isn't there.
///
/// \snippet influence.cpp influence
TRICOVER_EXPORT bool inInfluenceArea(const Polygon& polygon, std::size_t edge, const Vec2& point, double length,
                                     InfluenceKind kind);

/// One bit an edge: whether the point, in the polygon's frame, is in that edge's bounded area. Edge i has bit i % 64 of
/// word i / 64. If no bit is set, no edge comes within that length of the point.
///
/// Throws std::invalid_argument as inInfluenceArea() does.
///
/// \snippet influence.cpp influence mask
TRICOVER_EXPORT std::vector<std::uint64_t> influenceMask(const Polygon& polygon, const Vec2& point, double length);

/// The corners of an edge's bounded area, in order, rounded: for drawings.
///
/// Throws as inInfluenceArea() does.
///
/// \snippet influence.cpp bounded influence area
TRICOVER_EXPORT std::array<Vec2, 4> boundedInfluenceArea(const Polygon& polygon, std::size_t edge, double length);

}  // namespace tricover
