// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "polygon/polygon_data.h"

namespace tricover::detail {

/// A point of an overlap's boundary, in the WorldFrame, and the edges that it is on (positions; -1: none): a crossing
/// is on one of each, a vertex on two of its polygon.
struct BoundaryPoint {
  Vec2 at;
  std::int32_t a, a_before, b, b_before;
};

/// The next edge of a ring, all around, and the one before; positions in the path.
std::size_t edgeAfter(const PolygonData& polygon, std::size_t edge);
std::size_t edgeBefore(const PolygonData& polygon, std::size_t edge);

/// Whether the vertex at a position begins a ring that is one point.
bool beginsPoint(const PolygonData& polygon, std::size_t v);

/// A vertex of one side (0: a, 1: b), and the edges there beyond repetitions of it.
BoundaryPoint vertexPoint(const PolygonData& polygon, int side, std::size_t v, const Vec2& at);

}  // namespace tricover::detail
