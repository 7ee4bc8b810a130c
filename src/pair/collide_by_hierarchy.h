// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hierarchy/unit_map.h"
#include "pair/outcome.h"
#include "pair/posed_pair.h"
#include "tricover/collide.h"

namespace tricover::detail {

/// What a query wants to know beside the answer: nothing, how certain it is, or the edges of a hit. The less, the
/// shorter the ways to it.
enum class Wanted { Answer, Clearance, Edges };

/// The default: both hierarchies descended together. Whatever is farther apart than the margin by `lookahead` isn't
/// entered, so a clearance of at least that much is found if there is one. The bounding discs may meet. The pair must
/// be in order (inOrder()).
Outcome collideByHierarchy(const PosedPair& pair, const CollideOptions& options, double lookahead, Wanted wanted);

/// What is left of it where meetAtOnce() doesn't tell. The map and what gaps round by may be PolygonPlace's.
Outcome searchTrees(const PosedPair& pair, const UnitMap& map, double rounding, const CollideOptions& options,
                    double lookahead, Wanted wanted);

}  // namespace tricover::detail
