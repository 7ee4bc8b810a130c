// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/distance.h"

#include "distance/convex_distance.h"
#include "distance/distance_facts.h"
#include "distance/options.h"
#include "distance/point_distance.h"
#include "distance/tree_distance.h"
#include "numbers/rigidity.h"
#include "pair/kernel_order.h"
#include "polygon/cache_access.h"

namespace tricover {
namespace detail {

namespace {

/// By the first solver that is certain of its answer; the last one always is.
[[gnu::always_inline]] inline DistanceResult solve(const DistancePair& pair, DistanceFacts* cache,
                                                   const DistanceQuery& options) {
  DistanceResult result;
  if (pair.b.isPoint() && pointDistance(pair, options, result)) return result;
  if (cache != nullptr) claim(*cache, pair);
  if (!convexDistance(pair, cache, options, result)) result = treeDistance(pair, cache, options);
  return result;
}

DistanceResult distance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                        DistanceFacts* cache, const DistanceQuery& options) {
  const double defect = requireRigid(pose_a, pose_b);
  checkOptions(options);
  requireNotNegative(options.limit, "limit");
  const PolygonData &first = a.data(), &second = b.data();
  const bool is_swapped = !inOrder(first, pose_a, second, pose_b);
  return solve({is_swapped ? second : first, is_swapped ? pose_b : pose_a, is_swapped ? first : second,
                is_swapped ? pose_a : pose_b, is_swapped, defect},
               cache, options);
}

std::optional<DistanceResult> ifWithin(double limit, const DistanceResult& result) {
  return result.distance <= limit ? std::optional<DistanceResult>(result) : std::nullopt;
}

}  // namespace

DistanceResult distanceInOrder(const DistancePair& pair, const DistanceQuery& options) {
  return solve(pair, nullptr, options);
}

}  // namespace detail

DistanceResult distance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                        const DistanceOptions& options) {
  return detail::distance(a, pose_a, b, pose_b, nullptr, {options});
}

DistanceResult distance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, PairCache& cache,
                        const DistanceOptions& options) {
  return detail::distance(a, pose_a, b, pose_b, &detail::factsIn(cache).distance, {options});
}

std::optional<DistanceResult> distanceWithin(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                                             double limit, const DistanceOptions& options) {
  return detail::ifWithin(limit, detail::distance(a, pose_a, b, pose_b, nullptr, {options, limit}));
}

std::optional<DistanceResult> distanceWithin(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                                             double limit, PairCache& cache, const DistanceOptions& options) {
  return detail::ifWithin(limit,
                          detail::distance(a, pose_a, b, pose_b, &detail::factsIn(cache).distance, {options, limit}));
}

}  // namespace tricover
