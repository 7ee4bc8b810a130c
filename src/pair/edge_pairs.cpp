// SPDX-License-Identifier: BSD-3-Clause
#include "pair/edge_pairs.h"

#include "pair/pair_descent.h"

namespace tricover::detail {

void showEdgePairs(const PosedPair& pair, double limit, const PairVisitor& visitor) {
  if (visitor.narrow != nullptr && pair.b.isPoint()) {
    const UnitMap map = mapUnits(pair);
    return showEdgesNear(hierarchyOf(pair.a), {map.tx, map.ty, map.error}, limit * pair.a.inverse_unit,
                         static_cast<std::uint32_t>(pair.b.degenerate_edge), visitor);
  }
  showPairs(descentOf(pair, mapUnits(pair), gapRounding(pair), limit * pair.a.inverse_unit, visitor.narrow != nullptr),
            visitor);
}

}  // namespace tricover::detail
