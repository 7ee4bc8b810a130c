// SPDX-License-Identifier: BSD-3-Clause
#include "pair/collide_spine.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "pair/containment.h"
#include "pair/pair_descent.h"

namespace tricover::detail {
namespace {

/// A lower bound, in units, of the distance of a place from the box around everything; not positive where it may be
/// inside. The box's axis is of unit length as far as floats are: kGapRounding is far more than doubles add to that.
double distanceFromRoot(const Box& root, const Place& place) {
  const double dx = place.x - root.x, dy = place.y - root.y;
  const double along = std::max(std::abs(dx * root.ux + dy * root.uy) - root.along, 0.0);
  const double across = std::max(std::abs(dy * root.ux - dx * root.uy) - root.across, 0.0);
  const double squares = along * along + across * across;
  const double apart = squares < 1e300 ? std::sqrt(squares) : std::max(along, across);  // squares may overflow
  return apart - (std::abs(dx) + std::abs(dy) + 4) * kGapRounding - place.error;
}

struct PointTest {
  static bool meet(const void* context, std::size_t edge) {
    const PointTest& test = *static_cast<const PointTest*>(context);
    return edgesWithin(test.pair, edge, test.pair.b.spine, test.options.margin, test.options.tolerance);
  }

  const PosedPair& pair;
  const CollideOptions& options;
};

std::ptrdiff_t position(std::size_t edge) { return static_cast<std::ptrdiff_t>(edge); }

}  // namespace

Outcome collideSpines(const PosedPair& pair, const CollideOptions& options) {
  Outcome outcome;
  outcome.collides = edgesWithin(pair, pair.a.spine, pair.b.spine, options.margin, options.tolerance);
  if (!outcome.collides) return outcome;
  outcome.edge_a = position(pair.a.spine);
  outcome.edge_b = position(pair.b.spine);
  return outcome;
}

Outcome collidePoint(const PosedPair& pair, const CollideOptions& options, double lookahead, Wanted wanted) {
  assert(pair.b.isPoint() && !pair.a.hasSpine());
  const Hierarchy& tree = hierarchyOf(pair.a);
  const UnitMap map = mapUnits(pair);
  const Place place{map.tx, map.ty, map.error};
  const double unit = pair.a.unit, inverse_unit = pair.a.inverse_unit;
  const double reach = pair.reach(options.margin) * inverse_unit, limit = reach + lookahead * inverse_unit;
  // Rounded inwards, as reach is outwards.
  const double within = (1 - 2 * pair.scale_defect) * (1 - 0x1p-20) * inverse_unit;
  const double accept = (options.margin + options.tolerance) * within;
  Outcome outcome;
  const double outside = distanceFromRoot(tree.root, place);
  if (outside > limit) {
    outcome.clearance = outside * unit;
    return outcome;
  }
  if (!(outside > 0) && wanted != Wanted::Edges) {
    const double depth = depthInDiscs(tree.inner_discs, place);
    if (depth > 0 || -depth < accept) {
      outcome.collides = true;
      outcome.clearance = std::max(depth, 0.0) * unit;
      return outcome;
    }
  }
  const PointTest test{pair, options};
  const DescentResult found = findEdgeNear(tree, place, limit, {&test, &PointTest::meet, reach, accept});
  if (found.hit) {
    outcome.collides = true;
    outcome.edge_a = found.edge_a;
    outcome.edge_b = position(pair.b.spine);
    return outcome;
  }
  if (!(outside > 0)) outcome = findContainment(pair);
  if (wanted == Wanted::Clearance) outcome.clearance = found.clearance * unit;
  return outcome;
}

}  // namespace tricover::detail
