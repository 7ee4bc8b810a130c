// SPDX-License-Identifier: BSD-3-Clause
#include "contact/nearest_contact.h"

#include "contact/crossings.h"
#include "distance/distance_result.h"
#include "numbers/rigidity.h"
#include "numbers/segment.h"

namespace tricover::detail {

/// Beside the inner of an edge the normal is the edge's, which is known better than the way between points that are
/// near. Where that is nothing but rounding, b's S tells the side.
NearestContact nearestContact(const PosedPair& pair) {
  const double defect = defectOf(pair.pose_a, pair.pose_b);
  const DistanceResult nearest =
      distanceInOrder(DistancePair(pair.a, pair.pose_a, pair.b, pair.pose_b, false, defect), {});
  const auto position = [](const PolygonData& polygon, EdgeIndex edge) {
    return polygon.edgePosition(static_cast<std::size_t>(edge));
  };
  const WorldFrame frame(pair);
  const WorldFrame::Ends edge_a = frame.edgeEndsOfA(position(pair.a, nearest.edge_a)),
                         edge_b = frame.edgeEndsOfB(position(pair.b, nearest.edge_b));
  const auto [on_a, on_b] = nearestPlaces(edge_a, edge_b);
  const double error = 4 * frame.error();
  const Vec2 way = on_b - on_a, side = way.norm() > error ? way : Vec2(-frame.originOfA());
  const auto across = [&](const WorldFrame::Ends& edge) {
    const Vec2 normal = Vec2(edge.v.y() - edge.w.y(), edge.w.x() - edge.v.x()).stableNormalized();
    return normal.dot(side) < 0 ? Vec2(-normal) : normal;
  };
  const auto isInner = [&](const Vec2& p, const WorldFrame::Ends& edge) {
    return (p - edge.v).norm() > error && (p - edge.w).norm() > error;
  };
  if (isInner(on_a, edge_a)) return {nearest, across(edge_a)};
  if (isInner(on_b, edge_b)) return {nearest, across(edge_b)};
  return {nearest, side.isZero(0) ? Vec2(Vec2::UnitX()) : Vec2(side.stableNormalized())};
}

}  // namespace tricover::detail
