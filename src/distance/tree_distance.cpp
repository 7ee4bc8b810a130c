// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include "distance/distance_hint.h"
#include "distance/distance_search.h"
#include "distance/distance_solvers.h"
#include "pair/collide_by_hierarchy.h"
#include "pair/containment.h"
#include "pair/discs.h"
#include "pair/edge_pairs.h"

namespace tricover::detail {
namespace {

/// Shows the search what it must see; the result as of searchAll().
Outcome descend(const PosedPair& pair, DistanceSearch& search) {
  // The discs' farthest points are no nearer than any of the polygons.
  const Double2 way = absolute(pair.way());
  search.limitTo((way[0] + way[1] + pair.error() + pair.a.radius + pair.b.radius) * (1 + kLargestDefect));
  const auto limit = [&] { return EdgeDistances::above(search.reach()); };
  if (pair.a.isDegenerate() && pair.b.isDegenerate()) {
    search.show(pair.a.degenerate_edge, pair.b.degenerate_edge);
    return Outcome();
  }
  forEachPair(
      pair, limit(), [&](double, EdgePosition i, EdgePosition j) { return search.show(i, j) ? limit() : -1; },
      [&](double length) {
        search.limitTo(length);
        return limit();
      });
  return search.meets() ? Outcome() : findContainment(pair);
}

/// Shows the search what it must see when no hint meets; the result is where a ring lies inside the other region. The
/// discs are built for it: where they meet the regions do, and the common point is the one that collide() finds, the
/// deepest boxes first.
Outcome searchAll(const PosedPair& pair, DistanceSearch& search) {
  for (const PolygonData* polygon : {&pair.a, &pair.b})
    if (!polygon->isDegenerate()) innerDiscsOf(*polygon);
  if (!(depthOfDiscs(pair, 0) > 0)) return descend(pair, search);
  const Outcome outcome = collideByHierarchy(pair, {}, 0, Wanted::Edges);
  if (outcome.edge_a != kNoEdge && outcome.edge_b != kNoEdge) search.setMeeting(outcome.edge_a, outcome.edge_b);
  return outcome;
}

}  // namespace

DistanceResult treeDistance(const PosedVertices& pair, DistanceHint* hint, const DistanceQuery& options) {
  const BodyInField in_field(pair, pair.defect);
  const double apart = in_field.gap(0);
  if (apart > DistanceSearch::mostWithin(options))
    return {std::numeric_limits<double>::infinity(), Vec2::Zero(), Vec2::Zero(), -1, -1};
  const EdgeDistances edges(pair);
  DistanceSearch search(edges, options);
  // The bound tells in which order pairs are shown, and so which point is named where regions meet: not of those.
  if (apart > 0) search.limitTo(in_field.farthest());
  const bool was_tried = hint != nullptr && showHint(*hint, pair, search);
  const double hinted = search.upper();
  Outcome outcome;
  if (!search.meets()) outcome = searchAll(pair, search);
  if (hint != nullptr) storeHint(*hint, was_tried, hinted, search);
  if (outcome.collides && !search.meets()) return containedResult(pair, outcome.edge_a, outcome.edge_b);
  search.finish();
  return resultOf(pair, search.best(), search.meets(), search.edgeA(), search.edgeB(), options);
}

}  // namespace tricover::detail
