// SPDX-License-Identifier: BSD-3-Clause
#include "contact/contact_ends.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/boundary_point.h"
#include "numbers/segment.h"

namespace tricover::detail {

Contact contactAt(const Vec2& point, const Vec2& normal, double depth, EdgeIndex edge_a, EdgeIndex edge_b) {
  return {point, normal, depth, edge_a, edge_b, {{{point, depth}, {point, depth}}}, 1};
}

bool contactEnds(const Slope& lower, const Slope& upper, double depth, double margin, double error, ContactEnds& ends) {
  const double low = std::max(lower.low, upper.low), high = std::min(lower.high, upper.high);
  if (!(high - low > error)) return false;
  double gaps[2];
  for (std::size_t k = 0; k < 2; ++k) {
    const double place = k == 0 ? low : high, height = upper.at(place);
    gaps[k] = lower.at(place) - height;
    const double own = gaps[k] + margin;
    if (!(own >= -error && own <= depth + error)) return false;
    ends[k] = {place, height, std::clamp(own, 0.0, depth)};
  }
  // Where neither end is as deep as the contact, its depth is due to other edges.
  if (!(std::max(ends[0].depth, ends[1].depth) >= depth * (1 - 1e-9) - 4 * error)) return false;
  // How far the contact's point, which is at height 0, is from the upper piece to the lower one.
  const double t = std::clamp(-low / (high - low), 0.0, 1.0);
  const double gap = gaps[0] + t * (gaps[1] - gaps[0]), height = ends[0].height + t * (ends[1].height - ends[0].height);
  const double share = gap > 0 ? std::clamp(-height / gap, 0.0, 1.0) : 0.5;
  for (std::size_t k = 0; k < 2; ++k) ends[k].height += (gaps[k] > 0 ? share : 0.5) * gaps[k];
  if (ends[0].depth < ends[1].depth) std::swap(ends[0], ends[1]);
  ends[0].depth = depth;
  return true;
}

void addEnds(Contact& contact, const WorldFrame& frame, const WorldFrame::Ends& of_a, const WorldFrame::Ends& of_b,
             const Vec2& point, double margin) {
  const Vec2 &normal = contact.normal, along(-normal.y(), normal.x());
  ContactEnds ends;
  if (!contactEnds(Slope(of_a, point, normal), Slope(of_b, point, normal), contact.depth / frame.unit(),
                   margin / frame.unit(), 4 * frame.error(), ends))
    return;
  contact.count = 2;
  for (std::size_t k = 0; k < 2; ++k) {
    const ContactEnd& end = ends[k];
    contact.points[k] = {frame.toWorld(point + end.place * along + end.height * normal),
                         std::min(end.depth * frame.unit(), contact.depth)};
  }
}

WorldFrame::Ends straightPiece(const PosedPair& pair, const WorldFrame& frame, int side, EdgePosition edge,
                               const Extent& extent) {
  const PolygonData& polygon = side == 0 ? pair.a : pair.b;
  const auto at = [&](std::size_t k) { return frame.from(side, polygon.path[k]); };
  WorldFrame::Ends piece{at(edge), at(edge + 1)};
  const Vec2 start = piece.v, way = (piece.w - start).stableNormalized();
  if (way.isZero(0)) return piece;
  const auto goesOn = [&](const Vec2& end, const Vec2& next, const Vec2& forwards) {
    const double place = extent.along.dot(end);
    const bool is_left = extent.along.dot(forwards) > 0 ? place < extent.high : place > extent.low;
    return is_left && forwards.dot(next - end) >= 0 && std::abs(cross(way, next - start)) <= 4 * frame.error();
  };
  for (EdgePosition e = edgeAfter(polygon, edge); e != edge && goesOn(piece.w, at(e + 1), way);
       e = edgeAfter(polygon, e))
    piece.w = at(e + 1);
  for (EdgePosition e = edgeBefore(polygon, edge); e != edge && goesOn(piece.v, at(e), -way);
       e = edgeBefore(polygon, e))
    piece.v = at(e);
  return piece;
}

}  // namespace tricover::detail
