// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "numbers/predicates.h"
#include "polygon/polygon_data.h"
#include "tricover/locate.h"

namespace tricover::detail {

inline bool isInside(FillRule fill, int winding) { return fill == FillRule::EvenOdd ? winding % 2 != 0 : winding != 0; }

/// Where a point is, and, unless it is on the boundary, how often the rings wind around it in the polygon's own frame.
struct Inclusion {
  Location location;
  int winding;
};

/// The paper's Algorithm 1 with exact signs. The point is given twice: in the polygon's frame to within its error, and
/// exactly in the world, where `pose` (none: the identity) puts the polygon; `handed` is the sign of that pose's
/// determinant.
Inclusion includeInCovering(const PolygonData& polygon, const Pose* pose, const ApproxPoint& approx,
                            const PosedPoint& exact, int handed);
Location locateInCovering(const PolygonData& polygon, const Pose* pose, const ApproxPoint& approx,
                          const PosedPoint& exact, int handed);

}  // namespace tricover::detail
