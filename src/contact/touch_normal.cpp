// SPDX-License-Identifier: BSD-3-Clause
#include "contact/touch_normal.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tricover::detail {
namespace {

double angleOf(const Vec2& d) { return std::atan2(d.y(), d.x()); }

/// How far the one of some directions, sorted by angle, that leads farthest along the normal does so; at least 0.
double mostAlong(const std::vector<Vec2>& directions, const Vec2& normal) {
  if (directions.empty()) return 0;
  const auto isBefore = [](const Vec2& d, double angle) { return angleOf(d) < angle; };
  const auto next = std::lower_bound(directions.begin(), directions.end(), angleOf(normal), isBefore);
  const Vec2& after = next == directions.end() ? directions.front() : *next;
  const Vec2& before = next == directions.begin() ? directions.back() : *(next - 1);
  return std::max({0.0, before.dot(normal), after.dot(normal)});
}

/// Where the edges that meet at main's point lead from there, sorted by angle: a's on, b's turned back, so that none
/// should go along the normal.
std::vector<Vec2> directionsFrom(const WorldFrame& frame, const std::vector<EdgeCrossing>& crossings,
                                 const OverlapComponent& component, const EdgeCrossing& main) {
  const double error = frame.error();
  std::vector<std::size_t> edges_a, edges_b;
  for (const std::size_t k : component.crossings) {
    const EdgeCrossing& c = crossings[k];
    if ((c.point - main.point).norm() > 8 * error) continue;
    edges_a.push_back(c.edge_a);
    edges_b.push_back(c.edge_b);
  }
  std::vector<Vec2> directions;
  for (const bool of_a : {true, false}) {
    std::vector<std::size_t>& edges = of_a ? edges_a : edges_b;
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const std::size_t edge : edges) {
      const WorldFrame::Ends ends = of_a ? frame.edgeEndsOfA(edge) : frame.edgeEndsOfB(edge);
      for (const Vec2& end : {ends.v, ends.w}) {
        const Vec2 way = of_a ? Vec2(end - main.point) : Vec2(main.point - end);
        if (way.norm() > 8 * error) directions.push_back(way.normalized());
      }
    }
  }
  std::sort(directions.begin(), directions.end(), [](const Vec2& d, const Vec2& e) { return angleOf(d) < angleOf(e); });
  return directions;
}

}  // namespace

std::size_t longestStretch(const WorldFrame& frame, const std::vector<EdgeCrossing>& crossings,
                           const OverlapComponent& component) {
  const auto length = [&](std::size_t k) {
    const EdgeCrossing& c = crossings[k];
    const WorldFrame::Ends edge = frame.edgeEndsOfA(c.edge_a);
    return (edge.w - edge.v).norm() * (c.on_a.high - c.on_a.low);
  };
  std::size_t longest = component.crossings.front();
  for (const std::size_t k : component.crossings)
    if (length(k) > length(longest) + frame.error()) longest = k;
  return longest;
}

Vec2 touchNormal(const WorldFrame& frame, const std::vector<EdgeCrossing>& crossings, const OverlapComponent& component,
                 const EdgeCrossing& main, const Vec2& towards_b) {
  if (component.facing.norm() > 8 * frame.error()) return component.facing.normalized();
  const std::vector<Vec2> directions = directionsFrom(frame, crossings, component, main);
  constexpr double kSameAngle = 1e-9;
  Vec2 best = towards_b.isZero(0) ? Vec2(Vec2::UnitX()) : Vec2(towards_b.stableNormalized());
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2& direction : directions) {
    for (const Vec2& normal : {Vec2(direction.y(), -direction.x()), Vec2(-direction.y(), direction.x())}) {
      const double most = mostAlong(directions, normal);
      const bool better = normal.dot(towards_b) > best.dot(towards_b);
      if (most > least + kSameAngle || (most >= least - kSameAngle && !better)) continue;
      least = most;
      best = normal;
    }
  }
  return best;
}

}  // namespace tricover::detail
