// SPDX-License-Identifier: BSD-3-Clause
#include "pair/collide_degenerate.h"

#include <algorithm>
#include <cassert>

#include "pair/containment.h"
#include "pair/pair_descent.h"
#include "pair/point_place.h"

namespace tricover::detail {
namespace {

struct PointTest {
  static bool meet(const void* context, std::size_t edge) {
    const PointTest& test = *static_cast<const PointTest*>(context);
    return edgesWithin(test.pair, edge, test.pair.b.degenerate_edge, test.options.margin, test.options.tolerance);
  }

  const PosedPair& pair;
  const CollideOptions& options;
};

/// The same where no relative pose is known yet: most points never need one.
struct BarePointTest {
  static bool meet(const void* context, std::size_t edge) {
    const BarePointTest& test = *static_cast<const BarePointTest*>(context);
    return edgesWithin(PosedPair(test.a, test.pose_a, test.b, test.pose_b), edge, test.b.degenerate_edge,
                       test.options.margin, test.options.tolerance);
  }

  const PolygonData& a;
  const Pose& pose_a;
  const PolygonData& b;
  const Pose& pose_b;
  const CollideOptions& options;
};

/// In units, and rounded inwards: what is proven to be no farther away than this is a hit.
double acceptedWithin(const CollideOptions& options, double scale_defect, const PolygonData& a) {
  return (options.margin + options.tolerance) * ((1 - 2 * scale_defect) * (1 - 0x1p-20) * a.inverse_unit);
}

std::ptrdiff_t position(std::size_t edge) { return static_cast<std::ptrdiff_t>(edge); }

}  // namespace

Outcome collideDegenerate(const PosedPair& pair, const CollideOptions& options) {
  Outcome outcome;
  outcome.collides =
      edgesWithin(pair, pair.a.degenerate_edge, pair.b.degenerate_edge, options.margin, options.tolerance);
  if (!outcome.collides) return outcome;
  outcome.edge_a = position(pair.a.degenerate_edge);
  outcome.edge_b = position(pair.b.degenerate_edge);
  return outcome;
}

Outcome collidePoint(const PosedPair& pair, const CollideOptions& options, double lookahead, Wanted wanted) {
  assert(pair.b.isPoint() && !pair.a.isDegenerate());
  const Hierarchy& tree = hierarchyOf(pair.a);
  const UnitMap map = mapUnits(pair);
  const Place place{map.tx, map.ty, map.error};
  const double unit = pair.a.unit, inverse_unit = pair.a.inverse_unit;
  const double reach = pair.reach(options.margin) * inverse_unit, limit = reach + lookahead * inverse_unit;
  const double accept = acceptedWithin(options, pair.scale_defect, pair.a);
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
    outcome.edge_b = position(pair.b.degenerate_edge);
    return outcome;
  }
  if (!(outside > 0)) outcome = findContainment(pair);
  if (wanted == Wanted::Clearance) outcome.clearance = found.clearance * unit;
  return outcome;
}

bool pointMeets(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                const CollideOptions& options) {
  assert(b.isPoint());
  const Discs discs(a, pose_a, b, pose_b);
  if (discs.gap(options.margin) >= 0) return false;
  if (discs.depth(options.margin) >= 0) return true;
  const BarePointTest test{a, pose_a, b, pose_b, options};
  if (a.isDegenerate()) return BarePointTest::meet(&test, a.degenerate_edge);
  const PointPlace seen(a, pose_a, b, pose_b);
  const Hierarchy& tree = hierarchyOf(a);
  const double reach = options.margin * (1 + 2 * seen.defect) * a.inverse_unit;
  const double outside = distanceFromRoot(tree.root, seen.place);
  if (outside > reach) return false;
  const double accept = acceptedWithin(options, seen.defect, a);
  const bool may_be_inside = !(outside > 0);
  if (may_be_inside) {
    const double depth = depthInDiscs(tree.inner_discs, seen.place);
    if (depth > 0 || -depth < accept) return true;
  }
  if (findEdgeNear(tree, seen.place, reach, {&test, &BarePointTest::meet, reach, accept}).hit) return true;
  return may_be_inside && findContainment(PosedPair(a, pose_a, b, pose_b)).collides;
}

}  // namespace tricover::detail
