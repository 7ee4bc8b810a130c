// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pair/collide_by_hierarchy.h"

namespace tricover::detail {

/// collideByHierarchy() for a point b, by a's tree alone; or for two segments or points, by no tree.
Outcome collidePoint(const PosedPair& pair, const CollideOptions& options, double lookahead, Wanted wanted);
Outcome collideDegenerate(const PosedPair& pair, const CollideOptions& options);

/// Whether a point b meets a, or comes within the margin, by what is least for a single question: no fact comes of it.
bool pointMeets(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                const CollideOptions& options);

}  // namespace tricover::detail
