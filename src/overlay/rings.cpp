// SPDX-License-Identifier: BSD-3-Clause
#include "overlay/rings.h"

#include <algorithm>
#include <cmath>

#include "numbers/angle.h"
#include "numbers/convex_hull.h"
#include "numbers/segment.h"
#include "overlay/edge_sides.h"

namespace tricover::detail {
namespace {

/// Rings times vertices, at most, of polygons whose sides are known: what leads to a ring may pass all others.
constexpr std::size_t kMostLooks = std::size_t{1} << 20;

/// The side of an edge that the region is on. No rings meet, and so all edges of a ring have the same.
std::int8_t sideOf(const PosedRegions& itself, EdgePosition edge) {
  const EdgeSides beside(itself, EdgeSides::A, edge);
  if (!beside.hasAny(&EdgeSides::Piece::isBorder)) return 0;
  return beside.pieces()[0].own.left ? 1 : -1;
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

struct SidesOfRings : Derived::Thing {
  explicit SidesOfRings(const PolygonData& polygon) {
    const PosedRegions itself(polygon);
    const bool are_known = polygon.ringCount() * polygon.path.size() <= kMostLooks && !meetsItself(polygon);
    for (std::size_t r = 0; r < polygon.ringCount(); ++r) {
      sides.rings.push_back(are_known ? sideOf(itself, polygon.edgeBegin(r)) : std::int8_t{0});
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
    for (EdgePosition v = polygon.edgeBegin(r); v < polygon.edgeEnd(r); ++v)
      order.push_back(static_cast<std::uint32_t>(v));
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t v, std::uint32_t w) { return isBefore(polygon.path[v], polygon.path[w]); });
  return order;
}

bool meetsItself(const PolygonData& polygon) { return hierarchyOf(polygon).tangles.made<OwnMeetings>(polygon).some; }

const RegionSides& regionSidesOf(const PolygonData& polygon) {
  return hierarchyOf(polygon).sides.made<SidesOfRings>(polygon).sides;
}

}  // namespace tricover::detail
