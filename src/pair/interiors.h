// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "numbers/require_touching.h"
#include "pair/edge_sides.h"
#include "polygon/polygon_data.h"
#include "tricover/collide.h"

namespace tricover::detail {

/// Whether a point of one of the posed regions is in the interior of the other one. Exact, in whatever order the
/// operands are.
bool interiorsMeet(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b);

/// Whether an operand's edge, of a ring that is a point, is in the interior of the other region. The other's edges that
/// it is on are seams then. Exact.
bool isInInterior(const PosedPair& pair, EdgeSides::Operand operand, std::size_t edge, KnownSides& sides);

/// Whether that is what a query asks. With a margin it asks for a distance below it, edge by edge. With a tolerance
/// touching is within it, and may collide.
inline bool asksForInteriors(const CollideOptions& options) {
  return options.touching == Touching::Allowed && options.margin == 0 && options.tolerance == 0;
}

}  // namespace tricover::detail
