// SPDX-License-Identifier: BSD-3-Clause
#include "contact/region_sides.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "contact/own_crossings.h"
#include "numbers/angle.h"
#include "numbers/predicates.h"
#include "numbers/rigidity.h"
#include "numbers/segment.h"

namespace tricover::detail {
namespace {

/// Rings times vertices: what is looked at for a polygon's sides, at most.
constexpr std::size_t kMostLooks = std::size_t{1} << 20;

bool isLower(const Vec2& p, const Vec2& q) { return p.y() < q.y() || (p.y() == q.y() && p.x() < q.x()); }

/// How often the rings, none of which is on p or comes from below to it, go around what is just below p.
int windingBelow(const PolygonData& polygon, const Vec2& p) {
  int winding = 0;
  for (std::size_t r = 0; r < polygon.ringCount(); ++r)
    for (std::size_t e = polygon.edgeBegin(r); e < polygon.edgeEnd(r); ++e) {
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
RingSide sideOf(const PolygonData& polygon, std::size_t ring) {
  const std::size_t begin = polygon.edgeBegin(ring), end = polygon.edgeEnd(ring);
  const auto before = [&](std::size_t i) { return polygon.path[(i == begin ? end : i) - 1]; };
  std::size_t lowest = begin;
  for (std::size_t i = begin; i < end; ++i)
    if (isLower(polygon.path[i], polygon.path[lowest])) lowest = i;
  const int turn = orientation(before(lowest), polygon.path[lowest], polygon.path[lowest + 1]);
  const auto isInside = [&](int winding) {
    return polygon.fill == FillRule::NonZero ? winding != 0 : winding % 2 != 0;
  };
  // Just below its lowest vertex the ring itself is above.
  const int without = windingBelow(polygon, polygon.path[lowest]);
  const bool outer = isInside(without), inner = isInside(without + turn);
  RingSide side;
  side.side = static_cast<std::int8_t>(outer == inner ? 0 : inner ? turn : -turn);
  side.is_hole = outer && !inner;
  return side;
}

/// Between its outermost vertices along an axis, which a ring's diameter isn't below; of a hole that of its box.
double diameterOf(const PolygonData& polygon, const std::size_t ring, bool is_hole) {
  const Vec2 *const begin = &polygon.path[polygon.edgeBegin(ring)], *const end = &polygon.path[polygon.edgeEnd(ring)];
  const auto [left, right] =
      std::minmax_element(begin, end, [](const Vec2& p, const Vec2& q) { return p.x() < q.x(); });
  const auto [low, high] = std::minmax_element(begin, end, [](const Vec2& p, const Vec2& q) { return p.y() < q.y(); });
  const auto length = [](const Vec2& way) { return std::hypot(way.x(), way.y()); };
  if (is_hole) return length({right->x() - left->x(), high->y() - low->y()});
  return std::max(length(*right - *left), length(*high - *low));
}

/// What a ring turns by at its corners, in full turns, away from the region where its side is known.
double turningOf(const PolygonData& polygon, std::size_t ring, std::int8_t side) {
  const std::size_t begin = polygon.edgeBegin(ring), end = polygon.edgeEnd(ring);
  const auto along = [&](std::size_t e) {
    return Vec2(polygon.path[e + 1] * polygon.inverse_unit - polygon.path[e] * polygon.inverse_unit);
  };
  double turned = 0;
  Vec2 incoming = Vec2::Zero();
  for (std::size_t k = begin; k < 2 * end - begin; ++k) {  // around twice: what comes before the first edge?
    const Vec2 outgoing = along(k < end ? k : k - end + begin);
    if (outgoing.isZero(0)) continue;
    const double turn = std::atan2(cross(incoming, outgoing), incoming.dot(outgoing));
    if (k >= end) turned += side == 0 ? 2 * std::abs(turn) : std::max(side * turn, 0.0);
    incoming = outgoing;
  }
  return turned / (2 * kPi);
}

struct KnownSides : Derived::Thing {
  explicit KnownSides(const PolygonData& polygon) {
    sides.least_part = std::numeric_limits<double>::infinity();
    const bool are_known = polygon.ringCount() * polygon.path.size() <= kMostLooks && !meetsItself(polygon);
    for (std::size_t r = 0; r < polygon.ringCount(); ++r) {
      RingSide ring = are_known ? sideOf(polygon, r) : RingSide();
      ring.corners = turningOf(polygon, r, ring.side);
      ring.diameter = diameterOf(polygon, r, ring.is_hole);
      if (!ring.is_hole) sides.least_part = std::min(sides.least_part, ring.diameter);
      sides.rings.push_back(ring);
    }
  }

  RegionSides sides;
};

}  // namespace

/// Poses may change lengths by less than kLargestDefect, which allows for the roundings, too.
bool mayBound(const RingSide& ring, const RegionSides& other) {
  return !(ring.is_hole && ring.diameter * (1 + kLargestDefect) + kTiny < other.least_part * (1 - kLargestDefect));
}

const RegionSides& regionSidesOf(const PolygonData& polygon) {
  const Derived::Thing* known =
      hierarchyOf(polygon).sides.built([&] { return std::make_unique<const KnownSides>(polygon); });
  return static_cast<const KnownSides*>(known)->sides;
}

}  // namespace tricover::detail
