// SPDX-License-Identifier: BSD-3-Clause
#include "contact/coincident_vertices.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "hierarchy/pruned_lanes.h"
#include "numbers/convex_hull.h"

namespace tricover::detail {
namespace {

std::vector<std::uint32_t> placesOf(const Path& path) {
  const std::vector<std::uint32_t> order = sortedByPlace(path);
  std::vector<std::uint32_t> places(path.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    places[order[k]] = k > 0 && path[order[k]] == path[order[k - 1]] ? places[order[k - 1]] : order[k];
  return places;
}

struct IncidentEdge {
  double angle;
  std::size_t edge;
};

/// Edges that are so much longer than what their ends are wrong by that directions within kSameAngle tell them apart.
constexpr double kLongEnough = 0x1p30, kSameAngle = 1e-8;

/// The edges that end at a vertex or at repetitions of it, by their directions from there.
template <typename At>
std::vector<IncidentEdge> incidentEdges(const PolygonData& polygon, std::size_t vertex, double error, At at) {
  std::vector<IncidentEdge> star;
  const Vec2& p = polygon.path[vertex];
  const Vec2 from = at(p);
  for (std::size_t r = 0; r < polygon.ringCount(); ++r)
    for (std::size_t e = polygon.edgeBegin(r); e < polygon.edgeEnd(r); ++e) {
      const bool starts = polygon.path[e] == p;
      if (starts == (polygon.path[e + 1] == p)) continue;
      const Vec2 way = at(polygon.path[starts ? e + 1 : e]) - from;
      if (way.norm() > kLongEnough * error) star.push_back({std::atan2(way.y(), way.x()), e});
    }
  std::sort(star.begin(), star.end(), [](const IncidentEdge& e, const IncidentEdge& f) { return e.angle < f.angle; });
  return star;
}

/// Those without the directions of `others`; of one star with itself, of which every direction is one, without those
/// that are several.
std::vector<bool> alone(const PolygonData& polygon, const std::vector<IncidentEdge>& star,
                        const std::vector<IncidentEdge>& others, std::size_t allowed) {
  std::vector<bool> edges(polygon.path.size());
  const auto isBefore = [](const IncidentEdge& e, double angle) { return e.angle < angle; };
  for (const IncidentEdge& e : star) {
    const auto low = std::lower_bound(others.begin(), others.end(), e.angle - kSameAngle, isBefore),
               high = std::lower_bound(others.begin(), others.end(), e.angle + kSameAngle, isBefore);
    // Near the turn from pi to -pi they might be found on the other side.
    edges[e.edge] = static_cast<std::size_t>(high - low) <= allowed && std::abs(e.angle) < 3.14;
  }
  return edges;
}

}  // namespace

bool beginsPoint(const PolygonData& polygon, std::size_t v) {
  const std::size_t ring = polygon.ringOf(v);
  if (v != polygon.edgeBegin(ring)) return false;
  const Vec2 *const begin = polygon.path.begin() + v, *const end = polygon.path.begin() + polygon.edgeEnd(ring);
  return std::all_of(begin, end, [&](const Vec2& p) { return p == *begin; });
}

std::vector<std::uint32_t> sortedByPlace(const Path& path) {
  std::vector<std::uint32_t> order(path.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t v, std::uint32_t w) { return isBefore(path[v], path[w]); });
  return order;
}

CoincidentVertices::CoincidentVertices(const PosedPair& pair)
    : pair_(pair), place_a_(placesOf(pair.a.path)), place_b_(placesOf(pair.b.path)) {}

bool CoincidentVertices::isOne(std::size_t u, std::size_t v) const {
  const Vec2 &p = pair_.a.path[u], &q = pair_.b.path[v];
  const ApproxPoint at = pair_.fromB(q);
  if (!(std::abs(at.x - p.x()) <= at.error && std::abs(at.y - p.y()) <= at.error)) return false;
  return betweenExact({&pair_.pose_a, p}, {&pair_.pose_b, q}, {&pair_.pose_b, q});
}

std::pair<std::ptrdiff_t, std::ptrdiff_t> CoincidentVertices::largest(
    const std::vector<EdgeCrossing>& crossings) const {
  std::vector<std::size_t> of_a(place_a_.size()), of_b(place_b_.size());
  for (const std::uint32_t place : place_a_) ++of_a[place];
  for (const std::uint32_t place : place_b_) ++of_b[place];
  std::pair<std::ptrdiff_t, std::ptrdiff_t> largest(-1, -1);
  std::size_t most = 0;
  for (const EdgeCrossing& crossing : crossings)
    for (const std::size_t u : {crossing.edge_a, crossing.edge_a + 1})
      for (const std::size_t v : {crossing.edge_b, crossing.edge_b + 1}) {
        const std::size_t pairs = of_a[place_a_[u]] * of_b[place_b_[v]];
        if (pairs <= most || !isOne(u, v)) continue;
        most = pairs;
        largest = {static_cast<std::ptrdiff_t>(u), static_cast<std::ptrdiff_t>(v)};
      }
  return largest;
}

IncidentEdgeBoxes::IncidentEdgeBoxes(const PosedPair& pair, const WorldFrame& frame, std::size_t u, std::size_t v,
                                     CoincidentVertices& coincident) {
  const std::vector<IncidentEdge> of_a =
      incidentEdges(pair.a, u, frame.error(), [&](const Vec2& p) { return frame.fromA(p); });
  const std::vector<IncidentEdge> of_b =
      incidentEdges(pair.b, v, frame.error(), [&](const Vec2& p) { return frame.fromB(p); });
  std::vector<bool> alone_a = alone(pair.a, of_a, of_b, 0), alone_b = alone(pair.b, of_b, of_a, 0);
  if (of_a.empty() || of_b.empty()) return;
  const std::size_t edge_a = of_a.front().edge, edge_b = of_b.front().edge;
  alone_a[edge_a] = alone_b[edge_b] = false;
  coincident.tellBy(u, v, edge_a, edge_b);
  a_ = prunedLanes(pair.a, alone_a);
  b_ = prunedLanes(pair.b, alone_b);
}

IncidentEdgeBoxes::IncidentEdgeBoxes(const PolygonData& polygon, std::size_t v) {
  const std::vector<IncidentEdge> star =
      incidentEdges(polygon, v, 0x1p-50, [&](const Vec2& p) { return polygon.inUnits(p); });
  a_ = prunedLanes(polygon, alone(polygon, star, star, 1));
}

void CoincidentVertices::tellBy(std::size_t u, std::size_t v, std::size_t edge_a, std::size_t edge_b) {
  meetings_[std::uint64_t{place_a_[u]} << 32 | place_b_[v]] = {Met, edge_a, edge_b};
}

bool CoincidentVertices::isKnown(std::size_t i, std::size_t j) {
  for (const std::size_t u : {i, i + 1}) {
    const Vec2& p = pair_.a.path[u];
    for (const std::size_t v : {j, j + 1}) {
      const ApproxPoint q = pair_.fromB(pair_.b.path[v]);
      if (!(std::abs(q.x - p.x()) <= q.error && std::abs(q.y - p.y()) <= q.error)) continue;
      const PosedPoint at_a{&pair_.pose_a, p}, at_b{&pair_.pose_b, pair_.b.path[v]};
      MetEdges& meeting = meetings_[std::uint64_t{place_a_[u]} << 32 | place_b_[v]];
      if (meeting.state == New) meeting = {betweenExact(at_a, at_b, at_b) ? Met : Apart, i, j};
      if (meeting.state != Met || i == meeting.edge_a || j == meeting.edge_b) return false;
      const Vec2 &of_a = pair_.a.path[2 * i + 1 - u], &of_b = pair_.b.path[2 * j + 1 - v];
      const int turn = orientFilter(PosedPair::fromA(p), PosedPair::fromA(of_a), pair_.fromB(of_b));
      return turn == 1 || turn == -1;
    }
  }
  return false;
}

}  // namespace tricover::detail
