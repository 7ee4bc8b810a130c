// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "pair/facts.h"
#include "pair/outcome.h"
#include "polygon/polygon_data.h"
#include "tricover/collide.h"

namespace tricover::detail {

/// What finding a fact is to look for.
struct FactWish {
  double lookahead;                         ///< the clearance, beyond the margin, that is of use
  bool wants_clearance;                     ///< false: a clearance would be of no use
  std::ptrdiff_t edge_a = -1, edge_b = -1;  ///< tried first, unless -1
  bool was_apart = false;                   ///< whether these are the last fact's of polygons apart
};

/// Finds what a CollisionFact says of these poses: an Outcome whose clearance is a world length, 0 of a hit by the
/// margin or the tolerance alone; its edges may also be those at a FeaturePair's vertices. Operands in the kernel's
/// order, all arguments checked.
Outcome findFact(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                 const CollideOptions& options, const FactWish& wish);

/// collide() after recall(), and keeps what it found, if that may be of use.
bool renewFact(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b, CollisionFact& cache,
               const Recollection& recollection, const CollideOptions& options);

/// The same for polygons that are known not to overlap: nothing but the fact.
void renewFactApart(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                    CollisionFact& cache, const Recollection& recollection, const CollideOptions& options);

}  // namespace tricover::detail
