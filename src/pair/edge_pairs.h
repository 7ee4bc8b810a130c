// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hierarchy/simd.h"
#include "pair/posed_pair.h"

namespace tricover::detail {

/// Shows every pair of edges (positions in the paths) whose distance may be at most `limit`, near ones roughly first.
/// The limit is a length in a's frame (infinity shows all, in no order); what the visitor sees and returns is in a's
/// units (PolygonData::unit).
void showEdgePairs(const PosedPair& pair, double limit, const PairVisitor& visitor);

template <typename Visit>
struct PairCall {
  static double visit(void* context, double gap, std::uint32_t edge_a, std::uint32_t edge_b) {
    const PairCall& c = *static_cast<PairCall*>(context);
    return c.call(gap * c.unit, std::size_t{edge_a}, std::size_t{edge_b}) * c.inverse_unit;
  }

  Visit& call;
  double unit, inverse_unit;
};

/// showEdgePairs() for a callable visit(gap, edge_a, edge_b), which returns the new limit; all lengths in a's frame.
template <typename Visit>
void forEachPair(const PosedPair& pair, double limit, Visit visit) {
  PairCall<Visit> call{visit, pair.a.unit, pair.a.inverse_unit};
  showEdgePairs(pair, limit, {&call, &PairCall<Visit>::visit, nullptr});
}

/// The same for who looks for the nearest: narrow(length) is told of lengths that some pair is proven to be within, and
/// returns the new limit, too. Of a point or segment only the one edge that is all of it is shown.
template <typename Visit, typename Narrow>
void forNearPairs(const PosedPair& pair, double limit, Visit visit, Narrow narrow) {
  struct Call : PairCall<Visit> {
    Narrow& narrow;
  } call{{visit, pair.a.unit, pair.a.inverse_unit}, narrow};
  showEdgePairs(pair, limit,
                {static_cast<PairCall<Visit>*>(&call), &PairCall<Visit>::visit, [](void* context, double length) {
                   const Call& c = *static_cast<Call*>(static_cast<PairCall<Visit>*>(context));
                   return c.narrow(length * c.unit) * c.inverse_unit;
                 }});
}

}  // namespace tricover::detail
