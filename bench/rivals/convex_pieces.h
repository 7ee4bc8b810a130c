// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "tricover/polygon.h"

/// Convex shapes and triangles for rivals that know nothing else.
namespace tricover::bench {

using Triangle = std::array<Vec2, 3>;  ///< counter-clockwise

/// The region as triangles on the polygon's own vertices (GEOS's constrained Delaunay triangulation; GEOS adds vertices
/// only where edges cross). Throws std::runtime_error if the triangles' area isn't the region's.
std::vector<Triangle> triangulate(const Polygon& polygon);

/// Hertel and Mehlhorn: drops every diagonal that convexity can spare; at most four times the fewest pieces possible.
std::vector<Ring> convexPieces(const std::vector<Triangle>& triangles);

}  // namespace tricover::bench
