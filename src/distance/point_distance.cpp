// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>
#include <limits>

#include "distance/distance_solvers.h"
#include "hierarchy/simd.h"
#include "pair/posed_pair.h"
#include "pair/root_box.h"

namespace tricover::detail {

namespace {

/// Where they are nearest, of an edge and a point that isn't on it.
EdgeDistance besideEdge(const PosedVertices& pair, EdgePosition edge, const DistanceQuery& options) {
  const EdgePosition at = pair.b.degenerate_edge;
  const Foot foot = pair.foot<true>(edge, at);
  if (foot.is_plain) return {foot.distance, foot.part(), 0};
  const EdgeDistances edges(pair);
  return edges.at(edges.view(edge, at), edge, at, options, std::numeric_limits<double>::infinity());
}

}  // namespace

// Each distance is right to kRelativeError: so an edge that seems to be farther away than the nearest one is nearer by
// that share at most.
bool pointDistance(const PosedVertices& pair, const DistanceQuery& options, DistanceResult& result) {
  if (!pair.isUnscaled()) return false;
  if (pair.a.isDegenerate()) {
    const Foot only = pair.foot<true>(pair.a.degenerate_edge, pair.b.degenerate_edge);
    if (!only.is_plain) return false;
    result = plainResultOf(pair, {only.distance, only.part(), 0}, false, pair.a.degenerate_edge, pair.b.degenerate_edge,
                           options);
    return true;
  }
  const Place place = pair.inUnits(pair.defect).origin();
  const Hierarchy& tree = hierarchyOf(pair.a);
  if (!(distanceFromRoot(tree.region, place) > 0)) {
    const Location location = locateInA(pair, pair.b.path[pair.b.edgeBegin(0)]);
    if (location == Location::Boundary) return false;
    if (location == Location::Inside) {
      result = containedResult(pair, kNoEdge, pair.b.edgeBegin(0));
      return true;
    }
  }
  EdgePosition edges[kMostNearest], nearest = 0;
  const int count = findNearestEdges(tree, place, edges);
  if (count == 0) return false;
  EdgeDistance best{std::numeric_limits<double>::infinity(), 0, 0};
  for (int i = 0; i < count; ++i) {
    const EdgeDistance found = besideEdge(pair, edges[i], options);
    if (!(found.distance < best.distance)) continue;
    nearest = edges[i];
    best = found;
  }
  if (!(best.distance < std::numeric_limits<double>::infinity())) return false;
  result = plainResultOf(pair, best, false, nearest, pair.b.degenerate_edge, options);
  return true;
}

}  // namespace tricover::detail
