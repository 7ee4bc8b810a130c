// SPDX-License-Identifier: BSD-3-Clause
#include "pair/collide_by_hierarchy.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "pair/collide_degenerate.h"
#include "pair/containment.h"
#include "pair/meet_at_once.h"
#include "pair/pair_descent.h"

namespace tricover::detail {
namespace {

/// The edge test at the descent's leaves.
struct EdgeTest {
  static bool meet(const void* context, std::size_t edge_a, std::size_t edge_b) {
    const EdgeTest& test = *static_cast<const EdgeTest*>(context);
    return edgesWithin(test.pair, edge_a, edge_b, test.options.margin, test.options.tolerance);
  }

  const PosedPair& pair;
  const CollideOptions& options;
};

DescentResult descend(const PosedPair& pair, const UnitMap& map, double rounding, const CollideOptions& options,
                      double lookahead, Wanted wanted) {
  const double unit = pair.a.inverse_unit, sum = options.margin + options.tolerance;
  // Rounded inwards, for poses that aren't quite rigid and for the few roundings here and where it is compared.
  const bool accepts = sum > 0 && wanted != Wanted::Edges;
  const double accept = accepts ? sum * unit * (1 - 2 * pair.scale_defect) * (1 - 0x1p-20) : -1;
  const double reach = pair.reach(options.margin) * unit, limit = reach + lookahead * unit;
  const EdgeTest test{pair, options};
  return findHit(descentOf(pair, map, rounding, limit, /*degenerate*/ true),
                 {&test, &EdgeTest::meet, reach, accept, wanted == Wanted::Clearance});
}

}  // namespace

Outcome collideByHierarchy(const PosedPair& pair, const CollideOptions& options, double lookahead, Wanted wanted) {
  if (pair.a.isDegenerate() && pair.b.isDegenerate()) return collideDegenerate(pair, options);
  if (pair.b.isPoint()) return collidePoint(pair, options, lookahead, wanted);
  const UnitMap map = mapUnits(pair);
  const double rounding = gapRounding(pair), limit = (pair.reach(options.margin) + lookahead) * pair.a.inverse_unit;
  const EdgeTest test{pair, options};
  Outcome outcome;
  const Meeting meeting = meetAtOnce(hierarchyOf(pair.a), hierarchyOf(pair.b), map, rounding, limit, wanted,
                                     {&test, &EdgeTest::meet}, outcome.clearance);
  if (meeting == Meeting::Unknown) return searchTrees(pair, map, rounding, options, lookahead, wanted);
  outcome.collides = meeting == Meeting::Meet;
  outcome.clearance *= pair.a.unit;
  return outcome;
}

Outcome searchTrees(const PosedPair& pair, const UnitMap& map, double rounding, const CollideOptions& options,
                    double lookahead, Wanted wanted) {
  Outcome outcome;
  const DescentResult found = descend(pair, map, rounding, options, lookahead, wanted);
  if (found.hit) {
    outcome.collides = true;
    outcome.edge_a = found.edge_a;
    outcome.edge_b = found.edge_b;
    return outcome;
  }
  outcome = findContainment(pair);
  if (wanted == Wanted::Clearance)
    outcome.clearance = std::min(found.clearance * pair.a.unit, std::numeric_limits<double>::max());
  return outcome;
}

}  // namespace tricover::detail
