// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "impact/moving_pair.h"

namespace tricover::detail {

/// Whether findConvexImpact() may be asked: two convex polygons of few vertices, whose poses keep lengths but for
/// rounding.
bool isSmallConvexPair(const MovingPair& pair);

/// Conservative advancement from `begin` on, until which they are apart. Unknown at time 0 where they may touch there.
FirstContact findConvexImpact(const MovingPair& pair, double begin, double time_error);

}  // namespace tricover::detail
