// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "pair/outcome.h"
#include "polygon/polygon_data.h"
#include "tricover/collide.h"

namespace tricover::detail {

/// "At these poses the answer is `collides`, and whether the regions overlap stays so while no point is moved against
/// the other polygon by `clearance`, a world length, or more": see CollisionFact.
struct PairFact {
  bool collides;
  double clearance;               ///< 0 of a hit by the margin or the tolerance alone
  std::ptrdiff_t edge_a, edge_b;  ///< of a hit: see Outcome; of convex polygons apart: see FeaturePair
};

/// What finding a fact is to look for.
struct FactWish {
  double lookahead;                         ///< the clearance, beyond the margin, that is of use
  bool wants_clearance;                     ///< false: a clearance would be of no use
  std::ptrdiff_t edge_a = -1, edge_b = -1;  ///< tried first, unless -1
  bool was_apart = false;                   ///< whether these are the last fact's of polygons apart
};

/// Operands in the kernel's order, all arguments checked.
PairFact findFact(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                  const CollideOptions& options, const FactWish& wish);

/// collide() of arguments that have been checked, in any order, by what comes after discs have been asked.
bool collideClose(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                  const CollideOptions& options);

}  // namespace tricover::detail
