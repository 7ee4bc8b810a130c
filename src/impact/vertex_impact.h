// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "impact/moving_pair.h"

namespace tricover::detail {

/// Whether followVertices() may be called: b is a point, or both have at most 16 edges; their poses keep lengths but
/// for rounding.
bool haveFewVertices(const MovingPair& pair);

/// Of two that are apart from time 0 to `begin`. They meet first where a vertex of either comes to an edge of the
/// other.
FirstContact followVertices(const MovingPair& pair, double begin, double time_error);

}  // namespace tricover::detail
