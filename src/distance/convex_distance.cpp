// SPDX-License-Identifier: BSD-3-Clause
#include "distance/convex_distance.h"

#include <cmath>

#include "convex/nearest_features.h"
#include "distance/distance_facts.h"
#include "distance/distance_search.h"
#include "distance/edge_distance.h"
#include "hierarchy/simd.h"
#include "pair/placement.h"
#include "polygon/convexity.h"

namespace tricover::detail {
namespace {

/// Where edges cross, if plain doubles tell that they do.
void findCrossing(const PosedVertices& vertices, const FeaturePair& edges, ConvexOverlap& found) {
  if (const auto point = EdgeDistances(vertices).crossing(edges.edge_a, edges.edge_b)) {
    found.edges = edges;
    found.point = *point;
  }
}

EdgeDistance distanceOf(const NearestFeatures& nearest, const PosedVertices& vertices, const DistanceQuery& options) {
  const FeaturePair& features = nearest.features;
  const Foot& foot = nearest.foot;
  const bool is_vertices = features.kind == FeaturePair::kVertices, of_a = features.kind == FeaturePair::kEdgeOfA;
  if (!foot.is_plain && is_vertices)
    return EdgeDistances(vertices).startAndStart(foot, features.edge_a, features.edge_b, options);
  if (!foot.is_plain) return EdgeDistances(vertices).startBeside(of_a, foot, features.edge_a, features.edge_b, options);
  const double part = is_vertices ? 0 : foot.part();
  return {foot.distance, of_a ? part : 0, of_a ? 0 : part};
}

/// Of edges that can hold the least distance, all pairs.
DistanceResult leastDistance(const DistancePair& pair, const NearestFeatures& nearest, const PosedVertices& vertices,
                             const DistanceQuery& options) {
  const EdgeDistances edges(vertices);
  DistanceSearch search(edges, options);
  const ConvexRing a = convexRing(pair.a), b = convexRing(pair.b);
  for (std::uint32_t k = 0; k < nearest.edges_a.count; ++k)
    for (std::uint32_t l = 0; l < nearest.edges_b.count; ++l)
      search.showNear(a.after(nearest.edges_a.first, k), b.after(nearest.edges_b.first, l));
  search.finish();
  return resultOf(pair, search.best(), false, search.edgeA(), search.edgeB(), options);
}

DistanceResult resultOf(const DistancePair& pair, const NearestFeatures& nearest, const PosedVertices& vertices,
                        const DistanceQuery& options) {
  if (!nearest.is_unique) return leastDistance(pair, nearest, vertices, options);
  const std::size_t i = nearest.features.edge_a, j = nearest.features.edge_b;
  return plainResultOf(pair, distanceOf(nearest, vertices, options), false, i, j, options);
}

DistanceResult resultOf(const DistancePair& pair, const ConvexOverlap& overlap, const DistanceQuery& options) {
  if (!overlap.isInside())
    return plainResultOf(pair, overlap.point, true, overlap.edges.edge_a, overlap.edges.edge_b, options);
  Outcome outcome;
  outcome.edge_a = overlap.inner_a;
  outcome.edge_b = overlap.inner_b;
  return containedResult(pair, outcome);
}

}  // namespace

ConvexOverlap findConvexOverlap(const PosedVertices& vertices) {
  ConvexOverlap found;
  const SmallPolygon *a = hierarchyOf(vertices.a()).small_convex, *b = hierarchyOf(vertices.b()).small_convex;
  if (a == nullptr || b == nullptr) return found;
  const UnitPlacement at(PosedPair(vertices.a(), vertices.poseA(), vertices.b(), vertices.poseB()));
  if (!(std::abs(at.map.tx) + std::abs(at.map.ty) < 4)) return found;
  const ConvexCrossing crossing = convexCrossing(*a, *b, at.map, at.rounding);
  if (crossing.edge_a < 0 || crossing.edge_b < 0) {
    found.inner_a = crossing.edge_a;
    found.inner_b = crossing.edge_b;
    return found;
  }
  const FeaturePair guess{FeaturePair::kCrossing, static_cast<std::uint32_t>(crossing.edge_a),
                          static_cast<std::uint32_t>(crossing.edge_b)};
  findCrossing(vertices, guess, found);
  if (found.isFound()) return found;
  const EdgeDistances edges(vertices);
  if (!edges.meet(guess.edge_a, guess.edge_b)) return found;
  found.edges = guess;
  found.point = edges.whereTheyMeet(edges.view(guess.edge_a, guess.edge_b));
  return found;
}

std::optional<DistanceResult> convexDistance(const DistancePair& pair, const PosedVertices& vertices,
                                             DistanceFacts* cache, const DistanceQuery& options) {
  if (pair.a.isDegenerate() || pair.b.isDegenerate()) return std::nullopt;
  if (!convexityOf(pair.a).is_strict || !convexityOf(pair.b).is_strict) return std::nullopt;
  if (!vertices.isUnscaled()) return std::nullopt;
  const FeaturePair tried = cache != nullptr ? recallFeatures(*cache) : FeaturePair();
  const auto store = [&](bool were_right, const FeaturePair& found) {
    if (cache != nullptr) storeFeatures(*cache, tried, were_right, found);
  };
  if (tried.kind == FeaturePair::kCrossing) {
    ConvexOverlap overlap;
    findCrossing(vertices, tried, overlap);
    if (overlap.isFound()) {
      store(true, overlap.edges);
      return resultOf(pair, overlap, options);
    }
  }
  const NearestFeatures nearest = findNearestFeatures(vertices, tried);
  if (nearest.are_apart) {
    store(nearest.were_tried, nearest.features);
    return resultOf(pair, nearest, vertices, options);
  }
  if (!nearest.seem_to_meet) return std::nullopt;
  const ConvexOverlap overlap = findConvexOverlap(vertices);
  if (!overlap.isFound()) return std::nullopt;
  store(false, overlap.edges);
  return resultOf(pair, overlap, options);
}

}  // namespace tricover::detail
