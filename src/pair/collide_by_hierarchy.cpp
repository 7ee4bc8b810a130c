// SPDX-License-Identifier: BSD-3-Clause
#include "pair/collide_by_hierarchy.h"

#include <cassert>
#include <limits>

#include "pair/containment.h"

namespace tricover::detail {

Outcome searchTrees(const UnitPlacement& at, const EdgeTest& test, double lookahead, Wanted wanted) {
  const double sum = test.options.margin + test.options.tolerance;
  const double accept = sum > 0 && wanted != Wanted::Edges ? at.within(sum) : -1;
  const double reach = at.reach(test.options.margin), limit = reach + lookahead * at.inverse_unit;
  const Descent descent{test.a,      test.b, hierarchyOf(test.a), hierarchyOf(test.b), at.map,
                        at.rounding, limit,  /*degenerate*/ true};
  const DescentResult found = findHit(descent, {&test, &EdgeTest::meet, reach, accept, wanted == Wanted::Clearance});
  Outcome outcome;
  if (found.hit) {
    outcome.collides = true;
    outcome.edge_a = found.edge_a;
    outcome.edge_b = found.edge_b;
    return outcome;
  }
  outcome = findContainment(test.pair);
  if (wanted == Wanted::Clearance)
    outcome.clearance = std::min(at.inWorld(found.clearance, test.a.unit), std::numeric_limits<double>::max());
  return outcome;
}

Outcome collideByHierarchy(const PosedPair& pair, const CollideOptions& options, double lookahead, Wanted wanted) {
  return collideByHierarchy(pair.inUnits(), EdgeTest(pair, options), lookahead, wanted);
}

}  // namespace tricover::detail
