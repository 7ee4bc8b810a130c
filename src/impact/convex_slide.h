// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "impact/moving_pair.h"
#include "tricover/time_of_impact.h"

namespace tricover::detail {

/// For two convex polygons of at most 16 corners each, larger polygon first, that move straight and don't rotate: a ray
/// against their Minkowski difference, by the edge that separates them longest. `impact` describes a touch. Unknown at
/// time 0 for other operands, and where they may touch there. Unknown later where the ray passes that edge's ends: they
/// are apart until then.
FirstContact slideConvex(const PolygonData& a, const Motion& motion_a, const PolygonData& b, const Motion& motion_b,
                         double margin, Impact& impact);

}  // namespace tricover::detail
