// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "impact/moving_pair.h"
#include "tricover/impact.h"

namespace tricover::detail {

// The methods for the first contact. `begin` is a time before which the two are known to be apart.

/// For two convex polygons of at most 16 corners each, larger polygon first, that move straight and don't rotate: a ray
/// against their Minkowski difference, by the edge that separates them longest. `impact` describes a touch. Unknown at
/// time 0 for other operands, and where they may touch there. Unknown later where the ray passes that edge's ends: they
/// are apart until then.
FirstContact slideConvex(const PolygonData& a, const Motion& motion_a, const PolygonData& b, const Motion& motion_b,
                         double margin, Impact& impact);

/// Whether advanceAlongAxis() may be called: two convex polygons that don't rotate, or whose poses keep lengths but for
/// rounding.
bool isConvexPair(const MovingPair& pair);
/// Conservative advancement along the axis between the nearest features. Unknown at time 0 where they may touch there.
FirstContact advanceAlongAxis(const MovingPair& pair, double begin, double time_error);

/// Whether followVertices() may be called: b is a point, or both have at most 16 edges; their poses keep lengths but
/// for rounding.
bool haveFewVertices(const MovingPair& pair);
/// They meet first where a vertex of either comes to an edge of the other.
FirstContact followVertices(const MovingPair& pair, double begin, double time_error);

/// Best-first search over both hierarchies and time: slower than what knows more of its polygons, and fit for all.
FirstContact searchBoxes(const MovingPair& pair, double begin, double time_error);

/// timeOfImpact() with a margin of 0 or more, whatever they do at the begin. Arguments have been checked.
std::optional<Impact> impactOf(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b,
                               const ImpactOptions& options);
/// The operands' part of a result, for operands that have been swapped.
void swapOperands(std::optional<Impact>& impact);

}  // namespace tricover::detail
