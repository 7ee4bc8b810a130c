// SPDX-License-Identifier: BSD-3-Clause
#include "pair/collide_by_hierarchy.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "pair/containment.h"

namespace tricover::detail {
namespace {

/// The outcome of a descent; if no edges meet, and one region `may_hold` the other, the answer is containment's.
Outcome outcomeOf(const DescentResult& found, bool may_hold, const UnitMap& at, const EdgeTest& test, Wanted wanted) {
  if (found.hit) return {true, 0, found.edge_a, found.edge_b};
  Outcome outcome;
  if (may_hold) outcome = findContainment(test.pair);
  if (wanted == Wanted::Clearance)
    outcome.clearance = std::min(at.inWorld(found.clearance, test.a.unit), std::numeric_limits<double>::max());
  return outcome;
}

/// The same with a point b: a's tree alone is descended.
Outcome collidePoint(const UnitMap& at, const EdgeTest& test, double lookahead, Wanted wanted) {
  const Hierarchy& tree = hierarchyOf(test.a);
  const Place place = at.origin();
  const double reach = at.reach(test.options.margin), limit = reach + lookahead * at.inverse_unit;
  const double accept = at.within(test.options.margin + test.options.tolerance);
  const double outside = distanceFromRoot(tree.region, place);
  if (outside > limit) return {false, at.inWorld(outside, test.a.unit)};
  const bool may_be_inside = !(outside > 0);
  if (may_be_inside && wanted != Wanted::Edges) {
    if (const InnerDiscs* discs = innerDiscsIfPaid(test.a)) {
      const double depth = depthInDiscs(*discs, place);
      if (depth > 0 || -depth < accept) return {true, at.inWorld(std::max(depth, 0.0), test.a.unit)};
    }
  }
  DescentResult found = findEdgeNear(tree, place, limit, {&test, &EdgeTest::meetDegenerate, reach, accept});
  found.edge_b = test.b.degenerate_edge;
  return outcomeOf(found, may_be_inside, at, test, wanted);
}

}  // namespace

Outcome searchTrees(const UnitMap& at, const EdgeTest& test, double lookahead, Wanted wanted) {
  const double sum = test.options.margin + test.options.tolerance;
  const double accept = sum > 0 && wanted != Wanted::Edges ? at.within(sum) : -1;
  const double reach = at.reach(test.options.margin), limit = reach + lookahead * at.inverse_unit;
  const Descent descent{test.a, test.b, hierarchyOf(test.a), hierarchyOf(test.b), at, limit, /*degenerate*/ true};
  const DescentResult found = findHit(descent, {&test, &EdgeTest::meet, reach, accept, wanted == Wanted::Clearance});
  return outcomeOf(found, true, at, test, wanted);
}

Outcome collideDegenerate(const UnitMap& at, const EdgeTest& test, double lookahead, Wanted wanted) {
  if (!test.a.isDegenerate()) return collidePoint(at, test, lookahead, wanted);
  const EdgePosition i = test.a.degenerate_edge, j = test.b.degenerate_edge;
  if (!test(i, j)) return Outcome();
  return {true, 0, i, j};
}

Outcome collideByHierarchy(const PosedPair& pair, const CollideOptions& options, double lookahead, Wanted wanted) {
  return collideByHierarchy(pair.inUnits(), EdgeTest(pair, options), lookahead, wanted);
}

}  // namespace tricover::detail
