// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "posed_pair.h"
#include "wide.h"

namespace tricover::detail {

/// Shows every pair of edges (positions in the paths) whose distance may be at most `limit`, near ones roughly first.
/// The limit is a finite length in a's frame; what the visitor sees and returns is in a's units (PolygonData::unit).
void visitPairs(const PosedPair& pair, double limit, PairVisit visit, void* context);

/// visitPairs() for a callable visit(gap, edge_a, edge_b), which returns the new limit; all lengths in a's frame.
template <typename Visit>
void forEachPair(const PosedPair& pair, double limit, Visit visit) {
  struct Call {
    Visit& visit;
    double unit, inverse_unit;
  } call{visit, pair.a.unit, pair.a.inverse_unit};
  visitPairs(
      pair, limit,
      [](void* context, double gap, std::uint32_t edge_a, std::uint32_t edge_b) {
        const Call& c = *static_cast<Call*>(context);
        return c.visit(gap * c.unit, std::size_t{edge_a}, std::size_t{edge_b}) * c.inverse_unit;
      },
      &call);
}

}  // namespace tricover::detail
