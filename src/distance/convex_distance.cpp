// SPDX-License-Identifier: BSD-3-Clause
#include "distance/distance_hint.h"
#include "distance/distance_search.h"
#include "distance/edge_distance.h"
#include "distance/solvers.h"

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
  const std::size_t i = nearest.features.edge_a, j = nearest.features.edge_b;
  const EdgeDistance distance = EdgeDistances::ofFeatures(pair, nearest.features, nearest.foot, options);
  return plainResultOf(pair, distance, false, i, j, options);
}

DistanceResult resultOf(const PosedVertices& pair, const ConvexOverlap& overlap, const DistanceQuery& options) {
  if (!overlap.isInside())
    return plainResultOf(pair, overlap.point, true, overlap.edges.edge_a, overlap.edges.edge_b, options);
  return containedResult(pair, overlap.inner_a, overlap.inner_b);
}

}  // namespace

void findConvexOverlap(const PosedVertices& pair, const ConvexCrossing& crossing, ConvexOverlap& found) {
  if (crossing.edge_a < 0 || crossing.edge_b < 0) {
    found.inner_a = crossing.edge_a;
    found.inner_b = crossing.edge_b;
    return;
  }
  const auto i = static_cast<std::uint32_t>(crossing.edge_a), j = static_cast<std::uint32_t>(crossing.edge_b);
  if (!EdgeDistances::cross(pair, i, j, found.point)) {
    const EdgeDistances edges(pair);
    if (!edges.meet(i, j)) return;
    found.point = edges.whereTheyMeet(edges.view(i, j));
  }
  found.edges = {FeaturePair::kCrossing, i, j};
}

bool convexDistance(const PosedVertices& pair, DistanceHint* hint, const DistanceQuery& options,
                    DistanceResult& result) {
  const FeaturePair tried = hint != nullptr ? recallFeatures(*hint, pair) : FeaturePair();
  const auto store = [&](bool were_right, const FeaturePair& found) {
    if (hint != nullptr) storeFeatures(*hint, tried, were_right, found);
  };
  ConvexOverlap overlap;
  const bool was_right = tried.kind == FeaturePair::kCrossing && pair.isUnscaled() &&
                         EdgeDistances::cross(pair, tried.edge_a, tried.edge_b, overlap.point);
  if (was_right) {
    overlap.edges = tried;
  } else {
    const NearestFeatures nearest = findNearestFeatures(pair, tried);
    if (nearest.are_apart) {
      store(nearest.were_tried, nearest.features);
      result = resultOf(pair, nearest, options);
      return true;
    }
    if (!nearest.seem_to_meet) return false;
    findConvexOverlap(pair, nearest.crossing, overlap);
    if (!overlap.isFound()) return false;
  }
  store(was_right, overlap.edges);
  result = resultOf(pair, overlap, options);
  return true;
}

}  // namespace tricover::detail
