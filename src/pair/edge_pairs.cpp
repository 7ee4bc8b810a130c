// SPDX-License-Identifier: BSD-3-Clause
#include "pair/edge_pairs.h"

#include "pair/pair_descent.h"

namespace tricover::detail {

void showEdgePairs(const PosedPair& pair, double limit, const PairVisitor& visitor) {
  showPairs(descentOf(pair, mapUnits(pair), gapRounding(pair), limit * pair.a.inverse_unit, visitor.narrow != nullptr),
            visitor);
}

}  // namespace tricover::detail
