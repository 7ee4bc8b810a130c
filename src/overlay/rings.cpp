// SPDX-License-Identifier: BSD-3-Clause
#include "overlay/rings.h"

#include <algorithm>
#include <cmath>

#include "numbers/angle.h"
#include "numbers/convex_hull.h"
#include "numbers/segment.h"
#include "polygon/covering.h"

namespace tricover::detail {
namespace {

/// Rings times vertices: what is looked at for a polygon's sides, at most.
constexpr std::size_t kMostLooks = std::size_t{1} << 20;

bool isLower(const Vec2& p, const Vec2& q) { return p.y() < q.y() || (p.y() == q.y() && p.x() < q.x()); }

/// How often the rings, none of which is on p or comes from below to it, go around what is just below p.
int windingBelow(const PolygonData& polygon, const Vec2& p) {
  int winding = 0;
  for (std::size_t r = 0; r < polygon.ringCount(); ++r)
    for (EdgePosition e = polygon.edgeBegin(r); e < polygon.edgeEnd(r); ++e) {
      const Vec2 &v = polygon.path[e], &w = polygon.path[e + 1];
      const bool from_left = v.x() <= p.x(), to_left = w.x() <= p.x();
      if (from_left == to_left) continue;
      const int side = orientation(v, w, p);
      if (from_left && side > 0) ++winding;
      if (to_left && side < 0) --winding;
    }
  return winding;
}

/// Of rings that don't meet themselves, so that none turns back upon itself, but for triangles without an area: these
/// don't turn at all.
std::int8_t sideOf(const PolygonData& polygon, std::size_t ring) {
  const std::size_t begin = polygon.edgeBegin(ring), end = polygon.edgeEnd(ring);
  const auto before = [&](std::size_t i) { return polygon.path[(i == begin ? end : i) - 1]; };
  std::size_t lowest = begin;
  for (std::size_t i = begin; i < end; ++i)
    if (isLower(polygon.path[i], polygon.path[lowest])) lowest = i;
  const int turn = orientation(before(lowest), polygon.path[lowest], polygon.path[lowest + 1]);
  // Just below its lowest vertex the ring itself is above.
  const int without = windingBelow(polygon, polygon.path[lowest]);
  const bool outer = isInside(polygon.fill, without), inner = isInside(polygon.fill, without + turn);
  return static_cast<std::int8_t>(outer == inner ? 0 : inner ? turn : -turn);
}

/// What a ring turns by at its corners, in full turns, away from the region where its side is known.
double turningOf(const PolygonData& polygon, std::size_t ring, std::int8_t side) {
  const EdgePosition begin = polygon.edgeBegin(ring), end = polygon.edgeEnd(ring);
  const auto along = [&](EdgePosition e) {
    return Vec2(polygon.path[e + 1] * polygon.inverse_unit - polygon.path[e] * polygon.inverse_unit);
  };
  double turned = 0;
  Vec2 incoming = Vec2::Zero();
  for (EdgePosition k = begin; k < 2 * end - begin; ++k) {  // around twice: what comes before the first edge?
    const Vec2 outgoing = along(k < end ? k : k - end + begin);
    if (outgoing.isZero(0)) continue;
    const double turn = std::atan2(cross(incoming, outgoing), incoming.dot(outgoing));
    if (k >= end) turned += side == 0 ? 2 * std::abs(turn) : std::max(side * turn, 0.0);
    incoming = outgoing;
  }
  return turned / (2 * kPi);
}

struct RingSides : Derived::Thing {
  explicit RingSides(const PolygonData& polygon) {
    const bool are_known = polygon.ringCount() * polygon.path.size() <= kMostLooks && !meetsItself(polygon);
    for (std::size_t r = 0; r < polygon.ringCount(); ++r) {
      sides.rings.push_back(are_known ? sideOf(polygon, r) : std::int8_t{0});
      sides.corners += turningOf(polygon, r, sides.rings.back());
    }
  }

  RegionSides sides;
};

struct OwnMeetings : Derived::Thing {
  explicit OwnMeetings(const PolygonData& polygon) {
    const std::vector<std::uint32_t> order = verticesByPlace(polygon);
    const auto areEqual = [&](std::uint32_t v, std::uint32_t w) { return polygon.path[v] == polygon.path[w]; };
    some = std::adjacent_find(order.begin(), order.end(), areEqual) != order.end();
    if (!some) forEachOwnCrossing(polygon, [&](std::size_t, std::size_t) { return !(some = true); });
  }

  bool some;
};

}  // namespace

std::vector<std::uint32_t> verticesByPlace(const PolygonData& polygon) {
  std::vector<std::uint32_t> order;
  for (std::size_t r = 0; r < polygon.ringCount(); ++r)
    for (std::size_t v = polygon.edgeBegin(r); v < polygon.edgeEnd(r); ++v)
      order.push_back(static_cast<std::uint32_t>(v));
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t v, std::uint32_t w) { return isBefore(polygon.path[v], polygon.path[w]); });
  return order;
}

bool meetsItself(const PolygonData& polygon) { return hierarchyOf(polygon).tangles.made<OwnMeetings>(polygon).some; }

const RegionSides& regionSidesOf(const PolygonData& polygon) {
  return hierarchyOf(polygon).sides.made<RingSides>(polygon).sides;
}

}  // namespace tricover::detail
