// SPDX-License-Identifier: BSD-3-Clause
#include "distance/distance_hint.h"
#include "distance/distance_search.h"
#include "distance/distance_solvers.h"
#include "distance/edge_distance.h"

namespace tricover::detail {
namespace {

/// Of edges that can hold the least distance, all pairs.
DistanceResult leastDistance(const PosedVertices& pair, const NearestFeatures& nearest, const DistanceQuery& options) {
  const EdgeDistances edges(pair);
  DistanceSearch search(edges, options);
  const ConvexRing a = convexRing(pair.a), b = convexRing(pair.b);
  for (std::uint32_t k = 0; k < nearest.edges_a.count; ++k)
    for (std::uint32_t l = 0; l < nearest.edges_b.count; ++l)
      search.show(a.after(nearest.edges_a.first, k), b.after(nearest.edges_b.first, l));
  search.finish();
  return resultOf(pair, search.best(), false, search.edgeA(), search.edgeB(), options);
}

DistanceResult resultOf(const PosedVertices& pair, const NearestFeatures& nearest, const DistanceQuery& options) {
  if (!nearest.is_unique) return leastDistance(pair, nearest, options);
  const EdgePosition i = nearest.features.edge_a, j = nearest.features.edge_b;
  const EdgeDistance distance = EdgeDistances::ofFeatures(pair, nearest.features, nearest.foot, options);
  return plainResultOf(pair, distance, false, i, j, options);
}

/// Whether two edges share a point, which is certain, and where.
bool meet(const PosedVertices& pair, EdgePosition i, EdgePosition j, EdgeDistance& point) {
  if (EdgeDistances::cross(pair, i, j, point)) return true;
  const EdgeDistances edges(pair);
  if (!edges.meet(i, j)) return false;
  point = edges.whereTheyMeet(edges.view(i, j));
  return true;
}

}  // namespace

bool convexDistance(const PosedVertices& pair, DistanceHint* hint, const DistanceQuery& options,
                    DistanceResult& result) {
  const FeaturePair tried = hint != nullptr ? recallFeatures(*hint, pair) : FeaturePair();
  const auto store = [&](bool were_right, const FeaturePair& found) {
    if (hint != nullptr) storeFeatures(*hint, tried, were_right, found);
  };
  FeaturePair edges = tried;
  EdgeDistance point;
  const bool was_right = tried.kind == FeaturePair::kCrossing && pair.isUnscaled() &&
                         EdgeDistances::cross(pair, tried.edge_a, tried.edge_b, point);
  if (!was_right) {
    const NearestFeatures nearest = findNearestFeatures(pair, tried);
    if (nearest.are_apart) {
      store(nearest.were_tried, nearest.features);
      result = resultOf(pair, nearest, options);
      return true;
    }
    const EdgePosition edge_a = nearest.crossing.edge_a, edge_b = nearest.crossing.edge_b;
    if (!nearest.seem_to_meet || (edge_a == kNoEdge && edge_b == kNoEdge)) return false;
    if (edge_a == kNoEdge || edge_b == kNoEdge) {
      store(false, {});
      result = containedResult(pair, edge_a, edge_b);
      return true;
    }
    edges = {FeaturePair::kCrossing, edge_a, edge_b};
    if (!meet(pair, edges.edge_a, edges.edge_b, point)) return false;
  }
  store(was_right, edges);
  result = plainResultOf(pair, point, true, edges.edge_a, edges.edge_b, options);
  return true;
}

}  // namespace tricover::detail
