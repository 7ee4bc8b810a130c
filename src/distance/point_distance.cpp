// SPDX-License-Identifier: BSD-3-Clause
#include "distance/point_distance.h"

#include <cstdint>
#include <limits>

#include "hierarchy/placement.h"
#include "hierarchy/simd.h"
#include "pair/containment.h"
#include "pair/root_box.h"

namespace tricover::detail {

// Each foot is right to kRelativeError: so an edge that seems to be farther away than the nearest one is nearer by that
// share at most.
std::optional<PointFoot> nearestFoot(const PosedVertices& vertices, double defect) {
  if (!vertices.isUnscaled()) return std::nullopt;
  const PolygonData &a = vertices.a, &b = vertices.b;
  if (a.isDegenerate()) {
    const Foot only = vertices.foot<true>(a.degenerate_edge, b.degenerate_edge);
    return only.is_plain ? std::optional(PointFoot{a.degenerate_edge, only.distance, only.part(), false})
                         : std::nullopt;
  }
  const Place place = vertices.inUnits(defect).origin();
  const Hierarchy& tree = hierarchyOf(a);
  std::uint32_t edges[kMostNearest], nearest = 0;
  const int count = findNearestEdges(tree, place, edges);
  if (count == 0) return std::nullopt;
  double distance = std::numeric_limits<double>::infinity(), part = 0;
  for (int i = 0; i < count; ++i) {
    const Foot foot = vertices.foot<true>(edges[i], b.degenerate_edge);
    if (!foot.is_plain) return std::nullopt;
    if (!(foot.distance < distance)) continue;
    nearest = edges[i];
    distance = foot.distance;
    part = foot.part();
  }
  return PointFoot{nearest, distance, part, !(distanceFromRoot(tree.root, place) > 0)};
}

bool pointDistance(const DistancePair& pair, const DistanceQuery& options, DistanceResult& result) {
  const std::optional<PointFoot> nearest = nearestFoot(pair, pair.defect);
  if (!nearest) return false;
  if (nearest->may_be_inside) {
    const Outcome outcome = findContainment(PosedPair(pair.a, pair.pose_a, pair.b, pair.pose_b));
    if (outcome.collides) {
      result = containedResult(pair, outcome);
      return true;
    }
  }
  result =
      plainResultOf(pair, {nearest->distance, nearest->part, 0}, false, nearest->edge, pair.b.degenerate_edge, options);
  return true;
}

}  // namespace tricover::detail
