// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/distance.h"

#include "distance/distance_query.h"
#include "distance/distance_solvers.h"
#include "numbers/rigidity.h"
#include "pair/kernel_order.h"
#include "polygon/cache_access.h"
#include "polygon/convexity.h"

namespace tricover {
namespace detail {

namespace {

DistanceResult solve(const PosedVertices& pair, DistanceHint* hint, const DistanceQuery& options);

/// The number of the edge that an edge of its corners, or none, has at a point in the world.
EdgeIndex edgeOfGiven(const PolygonData& polygon, const PolygonData& corners, const Pose& pose, const Vec2& point,
                      EdgeIndex edge) {
  if (&corners == &polygon || edge < 0) return edge;
  const Vec2 in_frame = pose.linear().inverse() * (0.25 * point - 0.25 * pose.translation()) * 4;
  return edgeOfPath(polygon, static_cast<std::size_t>(edge), in_frame);
}

/// Where one isn't convex or has straight vertices; by the corners alone of what is convex.
[[gnu::noinline]] DistanceResult solveOthers(const PosedVertices& pair, const PolygonData* corners_a,
                                             const PolygonData* corners_b, DistanceHint* hint,
                                             const DistanceQuery& options) {
  const PolygonData &a = corners_a != nullptr ? *corners_a : pair.a, &b = corners_b != nullptr ? *corners_b : pair.b;
  if (&a == &pair.a && &b == &pair.b) return treeDistance(pair, hint, options);
  const DistanceResult found = solve({a, pair.pose_a, b, pair.pose_b, pair.defect}, hint, options);
  return inCallersOrder(pair, found.distance, found.point_a, found.point_b,
                        edgeOfGiven(pair.a, a, pair.pose_a, found.point_a, found.edge_a),
                        edgeOfGiven(pair.b, b, pair.pose_b, found.point_b, found.edge_b));
}

/// By the first solver that is certain of its answer; the last one always is.
[[gnu::always_inline]] inline DistanceResult solveInline(const PosedVertices& pair, DistanceHint* hint,
                                                         const DistanceQuery& options) {
  DistanceResult result;
  if (pair.b.isPoint() && pointDistance(pair, options, result)) return result;
  const PolygonData *a = cornersOf(pair.a), *b = cornersOf(pair.b);
  if (a != &pair.a || b != &pair.b) return solveOthers(pair, a, b, hint, options);
  return convexDistance(pair, hint, options, result) ? result : treeDistance(pair, hint, options);
}

DistanceResult solve(const PosedVertices& pair, DistanceHint* hint, const DistanceQuery& options) {
  return solveInline(pair, hint, options);
}

DistanceResult distance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, DistanceHint* hint,
                        const DistanceQuery& options) {
  const double defect = requireRigid(pose_a, pose_b);
  checkOptions(options);
  requireNotNegative(options.limit, "limit");
  const PolygonData &first = detail::dataOf(a), &second = detail::dataOf(b);
  const bool is_swapped = !inOrder(first, pose_a, second, pose_b);
  return solveInline({is_swapped ? second : first, is_swapped ? pose_b : pose_a, is_swapped ? first : second,
                      is_swapped ? pose_a : pose_b, defect, is_swapped},
                     hint, options);
}

std::optional<DistanceResult> ifWithin(double limit, const DistanceResult& result) {
  return result.distance <= limit ? std::optional<DistanceResult>(result) : std::nullopt;
}

}  // namespace

DistanceResult distanceInOrder(const PosedVertices& pair, const DistanceQuery& options) {
  return solve(pair, nullptr, options);
}

}  // namespace detail

DistanceResult distance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                        const DistanceOptions& options) {
  return detail::distance(a, pose_a, b, pose_b, nullptr, {options});
}

DistanceResult distance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, PairCache& cache,
                        const DistanceOptions& options) {
  return detail::distance(a, pose_a, b, pose_b, &detail::contentsOf(cache).distance, {options});
}

std::optional<DistanceResult> distanceWithin(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                                             double limit, const DistanceOptions& options) {
  return detail::ifWithin(limit, detail::distance(a, pose_a, b, pose_b, nullptr, {options, limit}));
}

std::optional<DistanceResult> distanceWithin(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                                             double limit, PairCache& cache, const DistanceOptions& options) {
  return detail::ifWithin(
      limit, detail::distance(a, pose_a, b, pose_b, &detail::contentsOf(cache).distance, {options, limit}));
}

}  // namespace tricover
