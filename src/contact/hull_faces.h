// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "contact/boundary_point.h"
#include "numbers/convex_hull.h"
#include "numbers/segment.h"

namespace tricover::detail {

/// The corners of a convex hull, counter-clockwise from the leftmost one. A segment has two, a point one. Signs are
/// rounded.
using Hull = std::vector<BoundaryPoint>;

inline Hull hullOf(std::vector<BoundaryPoint> points) {
  return convexHull(
      std::move(points), [](const BoundaryPoint& p) -> const Vec2& { return p.at; },
      [](const Vec2& p, const Vec2& q, const Vec2& r) { return cross(q - p, r - q) > 0; });
}

/// The points that may be corners of the hull: without those that are inside the triangle of the points beside them and
/// a middle, by twice its area more than `same_area`, which rounding may cost. Points of an outline are mostly left
/// out.
inline std::vector<BoundaryPoint> likelyCorners(const std::vector<BoundaryPoint>& points, double same_area) {
  constexpr std::size_t kWorthLooking = 32;
  if (points.size() < kWorthLooking) return points;
  const std::size_t quarter = points.size() / 4;
  const Vec2 middle = 0.25 * (points[0].at + points[quarter].at + points[2 * quarter].at + points[3 * quarter].at);
  std::vector<BoundaryPoint> likely(points.size());
  std::size_t count = 0;
  Vec2 u = points.back().at - middle, p = points.front().at - middle;
  double u_p = cross(u, p);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec2 v = points[k + 1 < points.size() ? k + 1 : 0].at - middle;
    const double p_v = cross(p, v), rest = cross(u, v) - u_p - p_v;
    const double least = std::min({u_p, p_v, rest}), most = std::max({u_p, p_v, rest});
    likely[count] = points[k];
    count += std::max(least, -most) > same_area ? 0 : 1;
    u = p, p = v, u_p = p_v;
  }
  likely.resize(count);
  return likely;
}

/// Whether every corner turns left: what rounded signs have made a hull of may not.
inline bool turnsLeft(const Hull& hull) {
  bool does = hull.size() > 2;
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const Vec2 &p = hull[k].at, &q = hull[(k + 1) % hull.size()].at, &r = hull[(k + 2) % hull.size()].at;
    does = does && cross(q - p, r - q) > 0;
  }
  return does;
}

/// Adds makePoint(), which is at p, to a hull of three corners or more, unless it holds p: in place of the corners
/// between the edges that p is beyond, or on the line of. Rounding may leave corners that don't turn left.
template <typename MakePoint>
void addToHull(Hull& hull, const Vec2& p, MakePoint makePoint) {
  const std::size_t count = hull.size();
  const auto next = [&](std::size_t k) { return k + 1 < count ? k + 1 : 0; };
  const auto before = [&](std::size_t k) { return k > 0 ? k - 1 : count - 1; };
  const auto turn = [&](std::size_t k) { return cross(hull[next(k)].at - hull[k].at, p - hull[k].at); };
  std::size_t from = 0;
  while (from < count && !(turn(from) < 0)) ++from;
  if (from == count) return;
  std::size_t to = next(from);
  while (next(to) != from && !(turn(to) > 0)) to = next(to);
  while (before(from) != to && !(turn(before(from)) > 0)) from = before(from);
  const auto at = [&](std::size_t k) { return hull.begin() + static_cast<std::ptrdiff_t>(k); };
  if (to > from) {
    hull.insert(hull.erase(at(from + 1), at(to)), makePoint());
  } else {
    hull.erase(at(from + 1), hull.end());
    hull.push_back(makePoint());
    hull.erase(hull.begin(), at(to));
  }
}

/// Calls visit(from, to, normal, depth, deepest) for every face of the hull that is wanted, by isWanted(from, to):
/// `body` reaches `depth` behind it, with `deepest`, which goes round the body as the face goes round the hull.
template <typename IsWanted, typename Visit>
void forEachFace(const Hull& hull, const Hull& body, IsWanted isWanted, Visit visit) {
  std::size_t deepest = 0;
  Vec2 last_way = Vec2::Zero();
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const BoundaryPoint &from = hull[k], &to = hull[k + 1 < hull.size() ? k + 1 : 0];
    if (!isWanted(from, to)) continue;
    const Vec2 way = to.at - from.at;
    if (way.isZero(0)) continue;
    const Vec2 normal = Vec2(way.y(), -way.x()).stableNormalized();
    const auto height = [&](std::size_t i) { return normal.dot(body[i].at - from.at); };
    double lowest = height(deepest);
    // After a half turn, and at first, there may be rises on the way to it, and nearly so rises by rounding.
    if (!(cross(last_way, way) > 0 && last_way.dot(way) > 0)) {
      for (std::size_t i = 0; i < body.size(); ++i) {
        const double at = height(i);
        deepest = at < lowest ? i : deepest;
        lowest = std::min(lowest, at);
      }
    }
    last_way = way;
    for (std::size_t steps = 0; steps < body.size(); ++steps) {
      const std::size_t next = deepest + 1 < body.size() ? deepest + 1 : 0;
      const double next_height = height(next);
      if (next_height > lowest) break;
      deepest = next;
      lowest = next_height;
    }
    visit(from, to, normal, -lowest, body[deepest]);
  }
}

}  // namespace tricover::detail
