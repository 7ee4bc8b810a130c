// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "impact/moving_pair.h"
#include "tricover/time_of_impact.h"

namespace tricover::detail {

/// Of two convex polygons of few corners each, in the kernel's order, that move straight and don't turn: a ray against
/// their Minkowski difference, by the edge that parts them longest. Of a touch `impact` is all there is to tell.
/// Unknown at time 0 for others, and where they may touch there; rarely later, before which they are apart.
FirstContact slideConvex(const PolygonData& a, const Motion& motion_a, const PolygonData& b, const Motion& motion_b,
                         double margin, Impact& impact);

}  // namespace tricover::detail
