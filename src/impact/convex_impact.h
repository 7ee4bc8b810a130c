// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "impact/moving_pair.h"

namespace tricover::detail {

/// Whether advanceAlongAxis() may be called: two convex polygons that don't rotate, or whose poses keep lengths but for
/// rounding.
bool isConvexPair(const MovingPair& pair);

/// Conservative advancement along the axis between the nearest features, from `begin` on, before which they are
/// apart. Unknown at time 0 where they may touch there.
FirstContact advanceAlongAxis(const MovingPair& pair, double begin, double time_error);

}  // namespace tricover::detail
