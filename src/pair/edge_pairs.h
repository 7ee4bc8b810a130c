// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hierarchy/simd.h"
#include "pair/posed_pair.h"

namespace tricover::detail {

template <typename Visit>
struct PairCall {
  static double visit(void* context, double gap, std::uint32_t edge_a, std::uint32_t edge_b) {
    const PairCall& c = *static_cast<PairCall*>(context);
    return c.at.reach(c.call(gap * c.unit, std::size_t{edge_a}, std::size_t{edge_b}));
  }

  Visit& call;
  const UnitPlacement& at;
  double unit;
};

/// Calls visit(gap, edge_a, edge_b), which returns the new limit, for every pair of edges (positions in the paths)
/// whose distance may be at most `limit`, near ones roughly first; infinity shows all, in no order. The gap is positive
/// only if the edges are apart.
template <typename Visit>
void forEachPair(const PosedPair& pair, double limit, Visit visit) {
  const UnitPlacement at = pair.inUnits();
  PairCall<Visit> call{visit, at, pair.a.unit};
  showPairs({pair.a, pair.b, hierarchyOf(pair.a), hierarchyOf(pair.b), at.map, at.rounding, at.reach(limit)},
            {&call, &PairCall<Visit>::visit, nullptr});
}

/// The same for callers that look for the nearest: narrow(length) is told of lengths that some pair is proven to be
/// within, and returns the new limit, too. Of a point or segment only the one edge that is all of it is shown.
template <typename Visit, typename Narrow>
void forNearPairs(const PosedPair& pair, double limit, Visit visit, Narrow narrow) {
  struct Call : PairCall<Visit> {
    Narrow& narrow;
  };
  const UnitPlacement at = pair.inUnits();
  Call call{{visit, at, pair.a.unit}, narrow};
  showPairs({pair.a, pair.b, hierarchyOf(pair.a), hierarchyOf(pair.b), at.map, at.rounding, at.reach(limit),
             /*degenerate*/ true},
            {static_cast<PairCall<Visit>*>(&call), &PairCall<Visit>::visit, [](void* context, double length) {
               const Call& c = *static_cast<Call*>(static_cast<PairCall<Visit>*>(context));
               return c.at.reach(c.narrow(length * c.unit * (1 + 2 * c.at.scale_defect)));
             }});
}

}  // namespace tricover::detail
