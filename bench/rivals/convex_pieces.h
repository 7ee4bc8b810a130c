// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "tricover/polygon.h"

/// What rivals that know only convex shapes or triangles need in a polygon's place.
namespace tricover::bench {

using Triangle = std::array<Vec2, 3>;  ///< counter-clockwise

/// The region as triangles on the polygon's own vertices (GEOS's constrained Delaunay triangulation; GEOS adds vertices
/// only where edges cross). Throws std::runtime_error if the triangles' area isn't the region's.
std::vector<Triangle> triangulate(const Polygon& polygon);

/// Hertel and Mehlhorn: drops every diagonal that convexity can spare; at most four times the fewest pieces possible.
std::vector<Ring> convexPieces(const std::vector<Triangle>& triangles);

bool isConvex(const Polygon& polygon);

}  // namespace tricover::bench
