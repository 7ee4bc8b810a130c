// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "convex/nearest_features.h"
#include "distance/distance_result.h"
#include "distance/distance_search.h"
#include "polygon/cache_contents.h"

namespace tricover::detail {

/// DistanceHint::kind: a kind of features of two convex polygons, or a pair of edges that may be near.
constexpr std::uint8_t kNoHint = FeaturePair::kNone, kNearEdges = FeaturePair::kCrossing + 1;

/// Makes the hint one of this pair. Empties it if it was another pair's.
inline void claim(DistanceHint& hint, const PosedVertices& pair) {
  if (hint.first_id == pair.a.id && hint.second_id == pair.b.id) return;
  hint = DistanceHint();
  hint.first_id = pair.a.id;
  hint.second_id = pair.b.id;
}

/// Whether the hint is to be tried by this query. Counts down a back-off.
inline bool isTried(DistanceHint& hint) {
  if (hint.kind == kNoHint) return false;
  if (!hint.back_off.isOn()) return true;
  --hint.back_off.left;
  return false;
}

/// The features that a hint names, if they are this pair's and to be tried.
inline FeaturePair recallFeatures(DistanceHint& hint, const PosedVertices& pair) {
  claim(hint, pair);
  if (hint.kind == kNearEdges || !isTried(hint)) return {};
  return {static_cast<FeaturePair::Kind>(hint.kind), hint.edge_a, hint.edge_b};
}

/// Keeps the features that were found, and judges those that were tried.
inline void storeFeatures(DistanceHint& hint, const FeaturePair& tried, bool were_right, const FeaturePair& found) {
  if (tried.kind != FeaturePair::kNone) hint.back_off.judge(were_right);
  hint.kind = found.kind;
  hint.edge_a = found.edge_a;
  hint.edge_b = found.edge_b;
}

/// Shows the search the edges that a hint names, as a first upper bound; whether there are any to be tried.
inline bool showHint(DistanceHint& hint, const PosedVertices& pair, DistanceSearch& search) {
  claim(hint, pair);
  if (hint.kind != kNearEdges || !isTried(hint)) return false;
  search.show(hint.edge_a, hint.edge_b);
  return true;
}

/// Keeps the pair of edges that meets or proves the search's upper bound. `hinted` is the bound that the hint gave, if
/// it was tried; twice the distance still prunes most of the trees.
inline void storeHint(DistanceHint& hint, bool was_tried, double hinted, const DistanceSearch& search) {
  if (was_tried) hint.back_off.judge(hinted <= 2 * search.upper());
  if (const ShownPair* nearest = search.nearest()) {
    hint.kind = kNearEdges;
    hint.edge_a = nearest->i;
    hint.edge_b = nearest->j;
  }
}

}  // namespace tricover::detail
