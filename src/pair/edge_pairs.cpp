// SPDX-License-Identifier: BSD-3-Clause
#include "pair/edge_pairs.h"

namespace tricover::detail {

void showEdgePairs(const PosedPair& pair, const UnitPlacement& at, double limit, const PairVisitor& visitor) {
  const bool nearest = visitor.narrow != nullptr;
  if (nearest && pair.b.isPoint())
    showEdgesNear(hierarchyOf(pair.a), at.origin(), limit, static_cast<std::uint32_t>(pair.b.degenerate_edge), visitor);
  else
    showPairs({pair.a, pair.b, hierarchyOf(pair.a), hierarchyOf(pair.b), at.map, at.rounding, limit,
               /*degenerate*/ nearest},
              visitor);
}

}  // namespace tricover::detail
