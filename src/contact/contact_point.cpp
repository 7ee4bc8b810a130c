// SPDX-License-Identifier: BSD-3-Clause
#include "contact/contact_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/boundary_ray.h"
#include "numbers/segment.h"

namespace tricover::detail {
namespace {

/// How far a unit vector leads from a point of the boundary, beyond its own edges, to the next edge of either polygon;
/// at most `length`.
double wayToNextEdge(const PosedPair& pair, const WorldFrame& frame, const Vec2& from, const Vec2& way, double length) {
  const double error = 8 * frame.error();
  for (const int side : {0, 1})
    forEachEdgeOnRay(pair, frame, side, from, way, length, [&](std::size_t edge) {
      const auto [v, w] = frame.edgeEnds(side, edge);
      const double over_v = cross(way, v - from), over_w = cross(way, w - from);
      if ((over_v > error && over_w > error) || (over_v < -error && over_w < -error)) return length;
      const double at_v = way.dot(v - from), at_w = way.dot(w - from);
      // Where the edge runs along the way, that is met at its nearer end; one that the way begins on is none.
      const bool across = std::abs(over_v - over_w) > error;
      const double t = across ? std::clamp(over_v / (over_v - over_w), 0.0, 1.0) : at_v < at_w ? 0 : 1;
      const double at = at_v + t * (at_w - at_v);
      if (at > error) length = std::min(length, at);
      return length;
    });
  return length;
}

}  // namespace

PartMiddle partMiddle(const Hull& part, const Vec2& up, double error) {
  const Vec2 side(-up.y(), up.x());
  double lowest = std::numeric_limits<double>::infinity(), first = lowest, last = -lowest;
  Vec2 deepest = Vec2::Zero();
  for (const BoundaryPoint& p : part) {
    const double height = up.dot(p.at);
    if (height < lowest) deepest = p.at;
    lowest = std::min(lowest, height);
  }
  for (const BoundaryPoint& p : part) {
    if (up.dot(p.at) > lowest + error) continue;
    first = std::min(first, side.dot(p.at));
    last = std::max(last, side.dot(p.at));
  }
  const double across = 0.5 * first + 0.5 * last;
  double highest = lowest;
  const Vec2* p = &part.back().at;
  double from = side.dot(*p) - across;
  for (const BoundaryPoint& corner : part) {
    const Vec2& q = corner.at;
    const double to = side.dot(q) - across;
    if (!(from > 0 && to > 0) && !(from < 0 && to < 0))
      highest = std::max(highest, up.dot(from != to ? Vec2(*p + from / (from - to) * (q - *p)) : *p));
    p = &q;
    from = to;
  }
  return {deepest, (0.5 * lowest + 0.5 * highest) * up + across * side};
}

Vec2 pointOfPart(const PosedPair& pair, const WorldFrame& frame, const PartMiddle& part, const Vec2& up) {
  const auto& [deepest, wanted] = part;
  const double error = 8 * frame.error();
  const auto isCommon = [&](const Vec2& p) { return holds(pair, frame, 0, p) && holds(pair, frame, 1, p); };
  const Vec2 way = wanted - deepest;
  const double length = way.norm();
  if (!(length > error)) return wanted;
  // `wanted` itself may be on an edge of another part, or behind one by rounding.
  const double free = wayToNextEdge(pair, frame, deepest, way / length, length);
  if (isCommon(deepest + 0.5 * way) && !(free < length - error))
    return free < length ? Vec2(deepest + (free / length) * way) : wanted;
  const double chord = wayToNextEdge(pair, frame, deepest, up, 0x1p1000);
  const Vec2 middle = deepest + 0.5 * chord * up;
  return chord < 0x1p1000 && isCommon(middle) ? middle : deepest;
}

}  // namespace tricover::detail
