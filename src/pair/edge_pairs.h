// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "hierarchy/simd.h"
#include "pair/posed_pair.h"

namespace tricover::detail {

/// Calls visit(gap, edge_a, edge_b), which returns the new limit, for every pair of edges (positions in the paths)
/// whose distance may be at most `limit`, near ones roughly first; infinity shows all, in no order. The gap is positive
/// only if the edges are apart.
///
/// Callers that look for the nearest give narrow(length), too: it is told of lengths that some pair is proven to be
/// within, and returns the new limit. Of a point or segment only the one edge that is all of it is shown then.
template <typename Visit, typename Narrow = std::nullptr_t>
void forEachPair(const PosedPair& pair, double limit, Visit visit, Narrow narrow = nullptr) {
  struct Call {
    Visit& visit;
    Narrow& narrow;
    const UnitMap& at;
    double unit;
  };
  const UnitMap at = pair.inUnits();
  Call call{visit, narrow, at, pair.a.unit};
  PairVisitor visitor{&call,
                      [](void* context, double gap, EdgePosition edge_a, EdgePosition edge_b) {
                        const Call& c = *static_cast<Call*>(context);
                        return c.at.reach(c.visit(gap * c.unit, edge_a, edge_b));
                      },
                      nullptr};
  constexpr bool kNearest = !std::is_same_v<Narrow, std::nullptr_t>;
  if constexpr (kNearest)
    visitor.narrow = [](void* context, double length) {
      const Call& c = *static_cast<Call*>(context);
      return c.at.reach(c.narrow(length * c.unit * (1 + 2 * c.at.scale_defect)));
    };
  showPairs({pair.a, pair.b, hierarchyOf(pair.a), hierarchyOf(pair.b), at, at.reach(limit), kNearest}, visitor);
}

}  // namespace tricover::detail
