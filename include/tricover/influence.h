// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tricover/polygon.h"

namespace tricover {

/// The areas of the paper's Section 4 and 5, around an edge (v, w), for a length n >= 0.
enum class InfluenceKind {
  OneSided,  ///< Figure 3: between the edge's line and its parallel at distance n, on the outer side, unbounded along
             ///< it
  Extended,  ///< Figure 4: within n of the edge's line, on both sides, unbounded along it
  Bounded,   ///< Figure 9b: Extended, cut by two axis-parallel lines at distance n beyond the vertices
};

/// Whether `point` (polygon's frame) lies in the area of `edge`. The outer side is the one away from S where the
/// covering triangle is positive and S's own side where it is negative (repaired: the paper's text is wrong in
/// concavities and holes), for rings that run with the region on their left. Rounded outwards: Extended and Bounded
/// hold every point within n of the edge, so a point outside them is proven to be farther than n. Decisions rest on
/// these two only. Throws std::invalid_argument for a negative or NaN length or a non-finite point, std::out_of_range
/// for the edge.
bool inInfluenceArea(const Polygon& polygon, std::size_t edge, const Vec2& point, double length, InfluenceKind kind);

/// One bit an edge (bit i % 64 of word i / 64): whether the point is in the edge's bounded area. No bit set proves that
/// the disc of that length around the point touches no edge.
std::vector<std::uint64_t> influenceMask(const Polygon& polygon, const Vec2& point, double length);

/// Corners, in order, of the bounded area of an edge, for drawing (rounded).
std::array<Vec2, 4> boundedInfluenceArea(const Polygon& polygon, std::size_t edge, double length);

}  // namespace tricover
