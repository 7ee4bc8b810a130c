// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "apart/moving_pair.h"

namespace tricover::detail {

/// Whether findConvexImpact() may be asked: two convex polygons of few vertices, whose poses keep lengths but for
/// rounding.
bool isSmallConvexPair(const MovingPair& pair);

/// What is known of the time of impact of such a pair.
struct ConvexImpact {
  enum class Verdict { Never, Touch, Unknown };
  Verdict verdict;
  double time;                 ///< they are certainly apart before; of a touch, it is at most `time_error` too early
  std::size_t edge_a, edge_b;  ///< of a touch: positions in the paths
};

/// Conservative advancement. Unknown at time 0 where they may touch there.
ConvexImpact findConvexImpact(const MovingPair& pair, double time_error);

}  // namespace tricover::detail
