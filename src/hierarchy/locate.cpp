// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/locate.h"

#include <algorithm>
#include <cmath>

#include "hierarchy/wide.h"
#include "numbers/errors.h"
#include "polygon/covering.h"

namespace tricover {
namespace detail {
namespace {

/// Signs of one point against lines through two points of a polygon's frame.
struct Signs {
  int operator()(const Vec2& v, const Vec2& w) const {
    const int sign = orientFilter({v.x(), v.y(), 0}, {w.x(), w.y(), 0}, approx);
    return sign != kUncertain ? sign : handed * orientExact({pose, v}, {pose, w}, exact);
  }
  bool between(const Vec2& v, const Vec2& w) const { return betweenExact(exact, {pose, v}, {pose, w}); }
  bool isPoint(const Vec2& v) const { return between(v, v); }

  const Pose* pose;
  ApproxPoint approx;
  PosedPoint exact;
  int handed;
};

/// Adds up twice the winding number, edge by edge. Any origin s serves that is not the point itself; the point lies in
/// the triangle (s, v, w) of sign g if it is between the rays s->v and s->w (g d_v >= 0 >= g d_w, with d_v the sign of
/// |s v p|) and on s's side of the edge; on one of the rays it counts half (the neighbouring triangle counts the other
/// half).
struct Winding {
  /// False if the point is on the edge: nothing else matters then.
  bool add(const Vec2& v, const Vec2& w) {
    const int d_v = signs(s, v), d_w = signs(s, w);
    const bool counter_clockwise = d_v >= 0 && d_w <= 0, clockwise = d_v <= 0 && d_w >= 0;
    if (!counter_clockwise && !clockwise) return true;
    const int g = orientation(s, v, w);
    // No part of the sum, but its points are boundary points (repair 5).
    if (g == 0) return on_boundary = signs(v, w) == 0 && signs.between(v, w), !on_boundary;
    if (!(g > 0 ? counter_clockwise : clockwise)) return true;
    const int side = g * signs(v, w);
    if (side > 0) sum += d_v != 0 && d_w != 0 ? 2 * g : g;
    on_boundary = side == 0;
    return !on_boundary;
  }

  static bool visit(void* winding, std::uint32_t edge) {
    auto& self = *static_cast<Winding*>(winding);
    return self.add(self.polygon.path[edge], self.polygon.path[edge + 1]);
  }

  const PolygonData& polygon;
  Vec2 s;
  Signs signs;
  int sum = 0;
  bool on_boundary = false;
};

void addAll(Winding& winding) {
  const PolygonData& polygon = winding.polygon;
  for (std::size_t r = 0; r < polygon.ringCount(); ++r)
    for (std::size_t e = polygon.edgeBegin(r); e < polygon.edgeEnd(r); ++e)
      if (!winding.add(polygon.path[e], polygon.path[e + 1])) return;
}

/// A triangle (s, v, w) holds the point only if the ray from the point away from s meets (v, w). False if rounding
/// hides where that ray goes.
bool addAlongRay(Winding& winding, const Hierarchy& hierarchy) {
  const PolygonData& polygon = winding.polygon;
  const ApproxPoint& p = winding.signs.approx;
  const double unit = polygon.inverse_unit;
  const Vec2 at = polygon.inUnits({p.x, p.y}), away = at - polygon.inUnits(winding.s);
  const double distance = away.norm(), error = p.error * unit + 0x1p-50;
  if (!(distance > 0x1p-10 && error < 0x1p-20 && polygon.radius <= polygon.unit)) return false;
  // The direction turns by at most 4 error / distance, and nothing is farther away than 4.
  const Ray ray{at.x(), at.y(), away.x() / distance, away.y() / distance, error * (2 + 16 / distance)};
  visitEdgesOnRay(hierarchy, ray, &Winding::visit, &winding);
  return true;
}

}  // namespace

Inclusion includeInCovering(const PolygonData& polygon, const Pose* pose, const ApproxPoint& approx,
                            const PosedPoint& exact, int handed) {
  const double dx = approx.x - polygon.origin.x(), dy = approx.y - polygon.origin.y();
  if (normBelow(dx, dy) > (polygon.radius + 2 * approx.error) * (1 + 4 * kUnitRoundoff)) return {Location::Outside, 0};
  const Hierarchy* hierarchy = polygon.hierarchyIfBuilt();

  Winding winding{polygon, polygon.origin, {pose, approx, exact, handed}};
  const bool off_origin = std::abs(dx) > approx.error || std::abs(dy) > approx.error;  // false for NaN
  // Every triangle would have the point as its corner: take the covering from a vertex. If that is the point, too, it
  // is found on that vertex's edge.
  if (!off_origin && (pose == nullptr || winding.signs.isPoint(winding.s))) winding.s = polygon.path.front();
  if (hierarchy == nullptr || !addAlongRay(winding, *hierarchy)) addAll(winding);
  if (winding.on_boundary) return {Location::Boundary, 0};
  return {isInside(polygon.fill, winding.sum / 2) ? Location::Inside : Location::Outside, winding.sum / 2};
}

Location locateInCovering(const PolygonData& polygon, const Pose* pose, const ApproxPoint& approx,
                          const PosedPoint& exact, int handed) {
  return includeInCovering(polygon, pose, approx, exact, handed).location;
}

}  // namespace detail

namespace {

void checkPoint(const Vec2& point) {
  if (!point.allFinite()) detail::refuse("point", "a coordinate is not finite");
}

Location locateUnchecked(const detail::PolygonData& polygon, const Vec2& point) {
  return detail::locateInCovering(polygon, nullptr, {point.x(), point.y(), 0}, {nullptr, point}, 1);
}

}  // namespace

Location locate(const Polygon& polygon, const Vec2& point) {
  checkPoint(point);
  // A scan costs a twentieth of a hierarchy: the first few points are no reason to build one.
  constexpr unsigned kScans = 16;
  const detail::PolygonData& data = polygon.data();
  if (data.hierarchyIfBuilt() == nullptr && data.scans.fetch_add(1, std::memory_order_relaxed) >= kScans)
    data.hierarchy();
  return locateUnchecked(data, point);
}

Location locate(const Polygon& polygon, const Vec2& point, PointCache& cache) {
  checkPoint(point);
  const detail::PolygonData& data = polygon.data();
  constexpr std::size_t kPerWord = 32;
  const std::size_t words = (data.path.size() + kPerWord - 1) / kPerWord;
  bool same_zone = cache.polygon_id == data.id && cache.signs.size() == words;
  if (!same_zone) cache.signs.assign(words, 0);

  // Every edge's sign, -1, 0 or 1, as two bits: the point's zone. The location is constant on an open face of the
  // lines' arrangement, but on a line it may change where no other line crosses (at a spike's tip), so a sign of 0 says
  // nothing. An edge of one repeated vertex has no line: it is 0 at that vertex only. The closing vertices between
  // rings form no edge; their lines divide zones no less soundly.
  for (std::size_t word = 0; word < words; ++word) {
    std::uint64_t bits = 0;
    const std::size_t end = std::min((word + 1) * kPerWord, data.path.size() - 1);
    for (std::size_t e = word * kPerWord; e < end; ++e) {
      const Vec2 &v = data.path[e], &w = data.path[e + 1];
      const int sign = v == w ? (point == v ? 0 : 1) : detail::orientation(v, w, point);
      same_zone = same_zone && sign != 0;
      bits |= static_cast<std::uint64_t>(sign + 1) << 2 * (e % kPerWord);
    }
    same_zone = same_zone && bits == cache.signs[word];
    cache.signs[word] = bits;
  }
  if (!same_zone) {
    cache.location = locateUnchecked(data, point);
    cache.polygon_id = data.id;
  }
  return cache.location;
}

}  // namespace tricover
