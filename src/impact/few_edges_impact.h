// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "impact/moving_pair.h"

namespace tricover::detail {

/// Whether findImpactOfFewEdges() may be asked: two polygons of at most sixteen vertices each, whose poses keep lengths
/// but for rounding.
bool haveFewEdges(const MovingPair& pair);

/// Of two that don't meet at time 0. They meet first where a vertex of either comes to an edge of the other.
FirstContact findImpactOfFewEdges(const MovingPair& pair, double time_error);

}  // namespace tricover::detail
