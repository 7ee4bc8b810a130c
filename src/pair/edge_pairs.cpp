// SPDX-License-Identifier: BSD-3-Clause
#include "pair/edge_pairs.h"

#include "hierarchy/placement.h"

namespace tricover::detail {

void showEdgePairs(const PosedPair& pair, double limit, const PairVisitor& visitor) {
  const UnitPlacement at = unitsOf(pair);
  const bool nearest = visitor.narrow != nullptr;
  if (nearest && pair.b.isPoint())
    showEdgesNear(hierarchyOf(pair.a), at.origin(), limit * at.inverse_unit,
                  static_cast<std::uint32_t>(pair.b.degenerate_edge), visitor);
  else
    showPairs({pair.a, pair.b, hierarchyOf(pair.a), hierarchyOf(pair.b), at.map, at.rounding, limit * at.inverse_unit,
               /*degenerate*/ nearest},
              visitor);
}

}  // namespace tricover::detail
