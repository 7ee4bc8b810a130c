// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cassert>

#include "pair/collide_by_hierarchy.h"
#include "pair/containment.h"

namespace tricover::detail {
namespace {

Outcome hit(std::int64_t edge_a, std::int64_t edge_b) { return {true, 0, edge_a, edge_b}; }

Outcome collidePoint(const UnitPlacement& at, const EdgeTest& test, double lookahead, Wanted wanted) {
  const Hierarchy& tree = hierarchyOf(test.a);
  const Place place = at.origin();
  const double unit = test.a.unit, sum = test.options.margin + test.options.tolerance;
  const double reach = at.reach(test.options.margin), limit = reach + lookahead * at.inverse_unit;
  const double accept = at.within(sum);
  const double outside = distanceFromRoot(tree.root, place);
  if (outside > limit) return {false, at.inWorld(outside, unit), -1, -1};
  const bool may_be_inside = !(outside > 0);
  if (may_be_inside && wanted != Wanted::Edges) {
    if (const InnerDiscs* discs = innerDiscsIfPaid(test.a)) {
      const double depth = depthInDiscs(*discs, place);
      if (depth > 0 || -depth < accept) return {true, at.inWorld(std::max(depth, 0.0), unit), -1, -1};
    }
  }
  const DescentResult found = findEdgeNear(tree, place, limit, {&test, &EdgeTest::meetDegenerate, reach, accept});
  if (found.hit) return hit(found.edge_a, static_cast<std::int64_t>(test.b.degenerate_edge));
  Outcome outcome;
  if (may_be_inside) outcome = findContainment(test.pair);
  if (wanted == Wanted::Clearance) outcome.clearance = at.inWorld(found.clearance, unit);
  return outcome;
}

}  // namespace

Outcome collideDegenerate(const UnitPlacement& at, const EdgeTest& test, double lookahead, Wanted wanted) {
  if (!test.a.isDegenerate()) return collidePoint(at, test, lookahead, wanted);
  const std::size_t i = test.a.degenerate_edge, j = test.b.degenerate_edge;
  return test(i, j) ? hit(static_cast<std::int64_t>(i), static_cast<std::int64_t>(j)) : Outcome();
}

}  // namespace tricover::detail
