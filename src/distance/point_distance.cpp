// SPDX-License-Identifier: BSD-3-Clause
#include "distance/point_distance.h"

#include <cstdint>

#include "hierarchy/simd.h"
#include "pair/containment.h"
#include "pair/placement.h"
#include "pair/root_box.h"

namespace tricover::detail {

// Each foot is right to kRelativeError: so an edge that seems to be farther away than the nearest one is nearer by that
// share at most.
std::optional<PointFoot> nearestFoot(const PosedVertices& vertices) {
  if (!vertices.isUnscaled()) return std::nullopt;
  const PolygonData &a = vertices.a(), &b = vertices.b();
  if (a.isDegenerate()) {
    const PointFoot only{a.degenerate_edge, vertices.foot<true>(a.degenerate_edge, b.degenerate_edge), false};
    return only.foot.is_plain ? std::optional(only) : std::nullopt;
  }
  const Place place = Placement(a, vertices.poseA(), b, vertices.poseB()).inUnits().origin();
  const Hierarchy& tree = hierarchyOf(a);
  std::uint32_t edges[kMostNearest];
  const int count = findNearestEdges(tree, place, edges);
  std::optional<PointFoot> best;
  for (int i = 0; i < count; ++i) {
    const Foot foot = vertices.foot<true>(edges[i], b.degenerate_edge);
    if (!foot.is_plain) return std::nullopt;
    if (!best || foot.distance < best->foot.distance) best = PointFoot{edges[i], foot, false};
  }
  if (best) best->may_be_inside = !(distanceFromRoot(tree.root, place) > 0);
  return best;
}

std::optional<DistanceResult> pointDistance(const DistancePair& pair, const PosedVertices& vertices,
                                            const DistanceQuery& options) {
  const std::optional<PointFoot> nearest = nearestFoot(vertices);
  if (!nearest) return std::nullopt;
  if (nearest->may_be_inside) {
    const Outcome outcome = findContainment(PosedPair(pair.a, pair.pose_a, pair.b, pair.pose_b));
    if (outcome.collides) return containedResult(pair, outcome);
  }
  return plainResultOf(pair, {nearest->foot.distance, nearest->foot.part(), 0}, false, nearest->edge,
                       pair.b.degenerate_edge, options);
}

}  // namespace tricover::detail
