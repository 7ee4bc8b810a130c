// SPDX-License-Identifier: BSD-3-Clause
#include "polygon/covering.h"

#include <cmath>

#include "polygon/edge_walk.h"

namespace tricover::detail {

CoveringSum::CoveringSum(const PolygonData& polygon, const IncludedPoint& point, const Vec2& origin)
    : polygon_(polygon), point_(point), s_(origin) {
  const ApproxPoint& p = point.approx;
  const auto isOff = [&](const Vec2& v, double by) {  // false for NaN
    return std::abs(p.x - v.x()) > p.error + by || std::abs(p.y - v.y()) > p.error + by;
  };
  // A ray away from a point this near has no certain direction. Another origin serves, if there is one.
  const double near = 0x1p-9 * polygon.unit;
  if (isOff(s_, near)) return;
  for (const std::size_t position : {std::size_t{0}, polygon.path.size() / 2})
    if (isOff(polygon.path[position], near)) {
      s_ = polygon.path[position];
      return;
    }
  // Every triangle would have the point as its corner: take the covering from a vertex. If that is the point, too, it
  // is found on that vertex's edge.
  if (!isOff(s_, 0) && (point.pose == nullptr || between(s_, s_))) s_ = polygon.path.front();
}

inline int CoveringSum::sign(const Vec2& v, const Vec2& w) const {
  return v == w ? 0 : point_.side(v, w);  // v == w at the vertex that the covering is taken from
}

inline bool CoveringSum::between(const Vec2& v, const Vec2& w) const {
  return betweenExact(point_.exact, {point_.pose, v}, {point_.pose, w});
}

bool CoveringSum::add(EdgePosition edge) {
  const Vec2 &v = polygon_.path[edge], &w = polygon_.path[edge + 1];
  const int d_v = sign(s_, v), d_w = sign(s_, w);
  const bool counter_clockwise = d_v >= 0 && d_w <= 0, clockwise = d_v <= 0 && d_w >= 0;
  if (!counter_clockwise && !clockwise) return true;
  const int g = v == s_ || w == s_ ? 0 : orientation(s_, v, w);
  // No part of the sum, but its points are boundary points (repair 5).
  if (g == 0) return on_boundary_ = sign(v, w) == 0 && between(v, w), !on_boundary_;
  if (!(g > 0 ? counter_clockwise : clockwise)) return true;
  const int side = g * sign(v, w);
  if (side > 0) sum_ += d_v != 0 && d_w != 0 ? 2 * g : g;
  on_boundary_ = side == 0;
  return !on_boundary_;
}

void CoveringSum::addAll() {
  forEachEdge(polygon_, [this](EdgePosition edge) { return add(edge); });
}

Inclusion CoveringSum::result() const {
  if (on_boundary_) return {Location::Boundary, 0};
  return {isInside(polygon_.fill, sum_ / 2) ? Location::Inside : Location::Outside, sum_ / 2};
}

}  // namespace tricover::detail
