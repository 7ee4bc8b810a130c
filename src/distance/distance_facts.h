// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "convex/feature_walk.h"
#include "distance/distance_result.h"
#include "distance/distance_search.h"
#include "pair/outcome.h"
#include "polygon/fact_balance.h"
#include "tricover/distance.h"

namespace tricover::detail {

/// DistanceFacts::hint: a kind of features of two convex polygons, or a pair of edges that may be near.
constexpr std::uint8_t kNoHint = FeaturePair::kNone, kNearEdges = FeaturePair::kCrossing + 1;

/// Keeps no facts, but where it was nearest.
inline void storeHint(DistanceFacts& cache, std::uint8_t hint, std::uint32_t edge_a, std::uint32_t edge_b) {
  cache.count = 0;
  cache.apart[0] = 0;
  cache.hint = hint;
  cache.first_edge[0] = edge_a;
  cache.second_edge[0] = edge_b;
}

/// Makes the cache one of this pair; empties it if it was another's.
inline void claim(DistanceFacts& cache, const DistancePair& pair) {
  if (cache.first_id == pair.a.id && cache.second_id == pair.b.id) return;
  cache = DistanceFacts();
  cache.first_id = pair.a.id;
  cache.second_id = pair.b.id;
}

/// The nearest features of two convex polygons that the cache keeps; none while those would seldom be right.
inline FeaturePair recallFeatures(DistanceFacts& cache) {
  if (cache.hint == kNoHint || cache.hint >= kNearEdges) return {};
  if (cache.balance.resting > 0) {
    --cache.balance.resting;
    return {};
  }
  return {static_cast<FeaturePair::Kind>(cache.hint), cache.first_edge[0], cache.second_edge[0]};
}

/// Keeps those that were found; `were_right` tells of those that were tried.
inline void storeFeatures(DistanceFacts& cache, const FeaturePair& tried, bool were_right, const FeaturePair& found) {
  // A few failures are nothing: features change now and then.
  if (tried.kind != FeaturePair::kNone) isWorthIt(cache.balance, were_right ? kQuery / 2 : -kQuery);
  storeHint(cache, found.kind, found.edge_a, found.edge_b);
}

/// Shows the search the pairs of edges in the cache's fact. An outcome (where a ring lies inside the other region, or
/// nothing) if they are enough for the answer. If they aren't, the search has seen something near and knows how far to
/// look ahead.
std::optional<Outcome> recallNearest(const DistancePair& pair, DistanceFacts& cache, DistanceSearch& search);
/// Keeps what the search has found since.
void storeNearest(const DistancePair& pair, DistanceFacts& cache, const DistanceSearch& search, const Outcome& outcome);

}  // namespace tricover::detail
