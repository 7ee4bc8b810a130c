// SPDX-License-Identifier: BSD-3-Clause
#include "contact/nearest_contact.h"

#include <algorithm>

#include "contact/boundary_point.h"
#include "contact/contact_ends.h"
#include "contact/crossings.h"
#include "distance/distance_result.h"
#include "numbers/segment.h"

namespace tricover::detail {

/// Beside the inner of an edge the normal is the edge's, which is known better than the way between points that are
/// near. Where that is nothing but rounding, b's S tells the side.
NearestContact nearestContact(const PosedPair& pair) {
  const DistanceResult nearest = distanceInOrder(PosedVertices(pair), {});
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

Contact contactBeside(const PosedPair& pair, double margin) {
  const auto [nearest, normal] = nearestContact(pair);
  const WorldFrame frame(pair);
  const double error = 4 * frame.error(), depth = std::max(margin - nearest.distance, 0.0);
  // At a vertex either edge may face the other polygon.
  const auto facing = [&, &normal = normal](int side, EdgeIndex number, const Vec2& point) {
    const PolygonData& polygon = side == 0 ? pair.a : pair.b;
    const std::size_t edge = polygon.edgePosition(static_cast<std::size_t>(number));
    const WorldFrame::Ends ends = frame.edgeEnds(side, edge);
    const Vec2 at = frame.fromWorld(point);
    const bool at_v = (at - ends.v).norm() <= error;
    if (!at_v && (at - ends.w).norm() > error) return edge;
    const BoundaryPoint vertex = vertexPoint(polygon, 0, at_v ? edge : edgeAfter(polygon, edge), at);
    return static_cast<std::size_t>(
        flatterEdge(vertex.a, vertex.a_before, normal, [&](std::size_t e) { return frame.edgeEnds(side, e); }));
  };
  const std::size_t edge_a = facing(0, nearest.edge_a, nearest.point_a),
                    edge_b = facing(1, nearest.edge_b, nearest.point_b);
  const Vec2 middle = nearest.point_a / 2 + nearest.point_b / 2;
  Contact contact = contactAt(middle, normal, depth, pair.a.edgeName(edge_a), pair.b.edgeName(edge_b));
  const Extent all{Vec2(-normal.y(), normal.x())};
  addEnds(contact, frame, straightPiece(pair, frame, 0, edge_a, all), straightPiece(pair, frame, 1, edge_b, all),
          frame.fromWorld(middle), margin);
  return contact;
}

}  // namespace tricover::detail
