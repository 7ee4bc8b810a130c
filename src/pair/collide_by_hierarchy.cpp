// SPDX-License-Identifier: BSD-3-Clause
#include "pair/collide_by_hierarchy.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "pair/collide_spine.h"
#include "pair/containment.h"
#include "pair/pair_descent.h"

namespace tricover::detail {
namespace {

/// A lower bound, in a's units, of the gap between the boxes around everything, by separating axes; not positive where
/// they may meet. No point of a is farther than 1 from its origin, and none of b from its own, because b's unit is at
/// most a's: so 4 is more than all extents together.
double rootGap(const Box& a, const Box& b, const UnitMap& map, double rounding) {
  assert(map.scale <= 1);
  const double ux = map.r00 * b.ux + map.r01 * b.uy, uy = map.r10 * b.ux + map.r11 * b.uy;
  const double dx = map.scale * (map.r00 * b.x + map.r01 * b.y) + map.tx - a.x;
  const double dy = map.scale * (map.r10 * b.x + map.r11 * b.y) + map.ty - a.y;
  const double along = b.along * map.scale, across = b.across * map.scale;
  const double c = std::abs(a.ux * ux + a.uy * uy), s = std::abs(a.ux * uy - a.uy * ux);
  const double gap = std::max(std::max(std::abs(dx * a.ux + dy * a.uy) - (a.along + along * c + across * s),
                                       std::abs(dy * a.ux - dx * a.uy) - (a.across + along * s + across * c)),
                              std::max(std::abs(dx * ux + dy * uy) - (along + a.along * c + a.across * s),
                                       std::abs(dy * ux - dx * uy) - (across + a.along * s + a.across * c)));
  return gap - rounding * (std::abs(dx) + std::abs(dy) + 4) - map.error;
}

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
  return findHit(descentOf(pair, map, rounding, limit, /*spines*/ true),
                 {&test, &EdgeTest::meet, reach, accept, wanted == Wanted::Clearance});
}

}  // namespace

Outcome collideByHierarchy(const PosedPair& pair, const CollideOptions& options, double lookahead, Wanted wanted) {
  if (pair.a.hasSpine() && pair.b.hasSpine()) return collideSpines(pair, options);
  if (pair.b.isPoint()) return collidePoint(pair, options, lookahead, wanted);
  const Hierarchy &a = hierarchyOf(pair.a), &b = hierarchyOf(pair.b);
  const UnitMap map = mapUnits(pair);
  const double rounding = gapRounding(pair);
  Outcome outcome;
  const bool near = std::abs(map.tx) + std::abs(map.ty) < 4;  // false for NaN
  if (a.small_ring && b.small_ring && near && wanted == Wanted::Answer && options.margin == 0) {
    const EdgeTest test{pair, options};
    const Meeting meeting = a.small_convex && b.small_convex
                                ? convexMeet(*a.small_ring, *b.small_ring, map, rounding)
                                : ringsMeet(*a.small_ring, *b.small_ring, map, rounding, {&test, &EdgeTest::meet});
    if (meeting != Meeting::Unknown) {
      outcome.collides = meeting == Meeting::Meet;
      return outcome;
    }
  }
  // Nothing of the regions is outside of the boxes around everything, so that no containment is left to ask for.
  const double gap = rootGap(a.root, b.root, map, rounding);
  if (gap * pair.a.unit > pair.reach(options.margin) + lookahead) {
    outcome.clearance = gap * pair.a.unit;
    return outcome;
  }
  // Inner discs hardly meet unless the boxes are deep in each other.
  const double deep = 0.7 * std::min<double>(a.root.across, b.root.across * map.scale);
  if (near && gap < -deep && wanted != Wanted::Edges) {
    const double depth = innerDepth(a.inner_discs, b.inner_discs, map, rounding);
    if (depth > 0) {
      outcome.collides = true;
      outcome.clearance = depth * pair.a.unit;
      return outcome;
    }
  }
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
