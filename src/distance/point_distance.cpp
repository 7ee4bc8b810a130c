// SPDX-License-Identifier: BSD-3-Clause
#include "distance/point_distance.h"

#include <cstdint>
#include <limits>

#include "hierarchy/simd.h"
#include "pair/containment.h"
#include "pair/placement.h"
#include "pair/root_box.h"

namespace tricover::detail {

// Each foot is right to kRelativeError: so an edge that seems to be farther away than the nearest one is nearer by that
// share at most.
std::optional<PointFoot> nearestFoot(const PosedVertices& vertices, double defect) {
  if (!vertices.isUnscaled()) return std::nullopt;
  const PolygonData &a = vertices.a(), &b = vertices.b();
  if (a.isDegenerate()) {
    const Foot only = vertices.foot<true>(a.degenerate_edge, b.degenerate_edge);
    return only.is_plain ? std::optional(PointFoot{a.degenerate_edge, only.distance, only.part(), false})
                         : std::nullopt;
  }
  const Place place = Placement(a, vertices.poseA(), b, vertices.poseB()).inUnits(defect).origin();
  const Hierarchy& tree = hierarchyOf(a);
  std::uint32_t edges[kMostNearest], nearest = 0;
  const int count = findNearestEdges(tree, place, edges);
  if (count == 0) return std::nullopt;
  Foot best{};
  best.distance = std::numeric_limits<double>::infinity();
  for (int i = 0; i < count; ++i) {
    const Foot foot = vertices.foot<true>(edges[i], b.degenerate_edge);
    if (!foot.is_plain) return std::nullopt;
    if (!(foot.distance < best.distance)) continue;
    nearest = edges[i];
    best = foot;
  }
  return PointFoot{nearest, best.distance, best.part(), !(distanceFromRoot(tree.root, place) > 0)};
}

std::optional<DistanceResult> pointDistance(const DistancePair& pair, const PosedVertices& vertices,
                                            const DistanceQuery& options) {
  const std::optional<PointFoot> nearest = nearestFoot(vertices, pair.defect);
  if (!nearest) return std::nullopt;
  if (nearest->may_be_inside) {
    const Outcome outcome = findContainment(PosedPair(pair.a, pair.pose_a, pair.b, pair.pose_b));
    if (outcome.collides) return containedResult(pair, outcome);
  }
  return plainResultOf(pair, {nearest->distance, nearest->part, 0}, false, nearest->edge, pair.b.degenerate_edge,
                       options);
}

}  // namespace tricover::detail
