// SPDX-License-Identifier: BSD-3-Clause
#include "contact/component_exit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_set>
#include <utility>

#include "pair/edge_pairs.h"

namespace tricover::detail {
namespace {

double angleOf(const Vec2& d) { return std::atan2(d.y(), d.x()); }

}  // namespace

const BoundaryPoint& leftmostOf(const OverlapComponent& component) {
  return *std::min_element(component.points.begin(), component.points.end(),
                           [](const BoundaryPoint& p, const BoundaryPoint& q) { return p.at.x() < q.at.x(); });
}

std::size_t longestStretch(const WorldFrame& frame, const std::vector<EdgeCrossing>& crossings,
                           const OverlapComponent& component) {
  const auto length = [&](std::size_t k) {
    const EdgeCrossing& c = crossings[k];
    const WorldFrame::Ends edge = frame.edgeEndsOfA(c.edge[0]);
    return (edge.w - edge.v).norm() * (c.on[0].high - c.on[0].low);
  };
  std::size_t longest = component.crossings.front();
  for (const std::size_t k : component.crossings)
    if (length(k) > length(longest) + frame.error()) longest = k;
  return longest;
}

Exit ComponentExits::exitOf(const OverlapComponent& component) {
  if (component.crossings.empty()) return byNearestEdge(component);
  if (!component.inner) return ofTouch(component);
  const Exit exit = byOutlines(component);
  // All of it may be one rounded point.
  return exit.depth < std::numeric_limits<double>::infinity() ? exit : ofTouch(component);
}

EdgePosition ComponentExits::flatter(int side, const BoundaryPoint& p, const Vec2& normal) const {
  if (p.edge[side] == kNoEdge) return kNoEdge;
  const EdgesAt at{p.edge[side], p.before[side]};
  return flatterEdge(at, normal, [&](EdgePosition e) { return frame_.edgeEnds(side, e); });
}

Exit ComponentExits::exitOfConvex(const OverlapComponent& component, const SeparatingAxes& axes) const {
  const SupportGap gap = leastSupportGap(pair_, &axes, 4 * frame_.error() * frame_.unit());
  const int face = gap.of_a ? 0 : 1, other = 1 - face;
  const PolygonData &own = polygonOf(pair_, face), &behind = polygonOf(pair_, other);
  const EdgePosition corner = convexOutlineOf(behind).corners[gap.deepest];
  const BoundaryPoint deepest = vertexPoint(behind, other, corner, frame_.from(other, behind.path[corner]));
  const Vec2 in_own = face == 0 ? frame_.toA(deepest.at) : frame_.toB(deepest.at);
  Exit exit{gap.normal, gap.depth / frame_.unit(), {kNoEdge, kNoEdge}, face};
  exit.edges[face] = pathEdge(own, convexOutlineOf(own), gap.edge, in_own);
  exit.edges[other] = flatter(other, deepest, gap.normal);
  if (component.crossings.empty()) exit.edges[component.points.front().edge[0] == kNoEdge ? 0 : 1] = kNoEdge;
  return exit;
}

/// The edge that separates last by a piece: at the end that does, the flatter one there.
EdgePosition ComponentExits::edgeOf(const OutlinePiece& piece, const Vec2& normal) const {
  const double up = (piece.side == 0 ? 1 : -1) * normal.dot(piece.way());
  if (std::abs(up) <= ExitLength::kSameAngle * piece.way().norm()) return piece.position;
  const PolygonData& polygon = polygonOf(pair_, piece.side);
  const EdgePosition end = up > 0 ? edgeAfter(polygon, piece.position) : piece.position;
  return flatter(piece.side, vertexPoint(polygon, piece.side, end, up > 0 ? piece.edge.w : piece.edge.v), normal);
}

/// The shortest translation by which b leaves a on every line through the component.
Exit ComponentExits::byOutlines(const OverlapComponent& component) const {
  // No line leaves a complement where none of its edges does: that is to be longer than any other exit.
  const double both = (pair_.a.radius + pair_.b.radius) / frame_.unit();
  const auto discOf = [&](const PolygonData& polygon, const Vec2& centre) {
    return ExitLength::Disc{centre, polygon.radius / frame_.unit() + (polygon.fill.is_complement ? 4 * both : 0)};
  };
  const ExitLength::Disc a = discOf(pair_.a, frame_.originOfA()), b = discOf(pair_.b, Vec2::Zero());
  OutlineExit shortest = shortestExit(component.pieces, a, b, frame_.error());
  std::vector<OutlinePiece> pieces;
  if (shortest.is_doubtful) {
    pieces = component.pieces;
    pieces.insert(pieces.end(), component.around.begin(), component.around.end());
    const OutlineExit beyond = shortestExit(pieces, a, b, frame_.error());
    // That search may end early, with a longer one.
    if (!(beyond.length > shortest.length + 4 * frame_.error())) shortest = beyond;
  }
  Exit exit{shortest.normal, shortest.length, {kNoEdge, kNoEdge}, shortest.of_a ? 0 : 1};
  if (!(exit.depth < std::numeric_limits<double>::infinity())) return exit;
  for (const OutlinePiece* piece : {shortest.found.top, shortest.found.bottom})
    if (piece != nullptr) exit.edges[piece->side] = edgeOf(*piece, exit.normal);
  completeEdges(component, exit);
  return exit;
}

/// The deepest point may be a vertex of the other polygon, and have no edge of its own.
void ComponentExits::completeEdges(const OverlapComponent& component, Exit& exit) const {
  for (const int side : {0, 1}) {
    if (exit.edges[side] != kNoEdge) continue;
    double farthest = -std::numeric_limits<double>::infinity();
    for (const BoundaryPoint& point : component.points) {
      const double along = (side == 0 ? 1 : -1) * exit.normal.dot(point.at);
      if (point.edge[side] == kNoEdge || !(along >= farthest)) continue;
      farthest = along;
      exit.edges[side] = point.edge[side];
    }
  }
}

Exit ComponentExits::ofTouch(const OverlapComponent& component) const {
  const EdgeCrossing& main = crossings_[longestStretch(frame_, crossings_, component)];
  return {normalOfTouch(component, main), 0, {main.edge[0], main.edge[1]}, 0};
}

/// From a to b. Where edges touch along an interval, across these. Where they share a point alone, the normal of one of
/// its edges: the one that both polygons' edges keep to their sides of best, among equal ones that nearest to b's
/// origin.
Vec2 ComponentExits::normalOfTouch(const OverlapComponent& component, const EdgeCrossing& main) const {
  if (component.facing.norm() > 8 * frame_.error()) return component.facing.normalized();
  const std::vector<Vec2> directions = directionsFrom(component, main);
  constexpr double kSameAngle = 1e-9;
  Vec2 best = towards_b_.isZero(0) ? Vec2(Vec2::UnitX()) : Vec2(towards_b_.stableNormalized());
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2& direction : directions) {
    for (const Vec2& normal : {Vec2(direction.y(), -direction.x()), Vec2(-direction.y(), direction.x())}) {
      double most = 0;
      for (const Vec2& other : directions) most = std::max(most, other.dot(normal));
      const bool better = normal.dot(towards_b_) > best.dot(towards_b_);
      if (most > least + kSameAngle || (most >= least - kSameAngle && !better)) continue;
      least = most;
      best = normal;
    }
  }
  return best;
}

/// Where the edges that meet at main's point lead from there, sorted by angle: a's on, b's reversed, so that none
/// should go along the normal.
std::vector<Vec2> ComponentExits::directionsFrom(const OverlapComponent& component, const EdgeCrossing& main) const {
  const double error = frame_.error();
  std::vector<Vec2> directions;
  for (const int side : {0, 1}) {
    std::vector<EdgePosition> edges;
    for (const std::size_t k : component.crossings)
      if (!((crossings_[k].point - main.point).norm() > 8 * error)) edges.push_back(crossings_[k].edge[side]);
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const EdgePosition edge : edges) {
      const WorldFrame::Ends ends = frame_.edgeEnds(side, edge);
      for (const Vec2& end : {ends.v, ends.w}) {
        const Vec2 way = side == 0 ? Vec2(end - main.point) : Vec2(main.point - end);
        if (way.norm() > 8 * error) directions.push_back(way.normalized());
      }
    }
  }
  std::sort(directions.begin(), directions.end(), [](const Vec2& d, const Vec2& e) { return angleOf(d) < angleOf(e); });
  return directions;
}

/// One side's rings that a containment is made of, as a polygon of their own.
Polygon ComponentExits::ringsOf(const OverlapComponent& component, int side) const {
  const PolygonData& polygon = polygonOf(pair_, side);
  std::vector<Ring> rings;
  std::size_t last = polygon.ringCount();
  for (const BoundaryPoint& point : component.points) {
    if (point.edge[side] == kNoEdge) continue;
    const std::size_t ring = polygon.ringOf(point.edge[side]);
    if (ring != last) rings.push_back(polygon.vertices(ring));
    last = ring;
  }
  return Polygon(rings, polygon.fill.rule);  // for its edges alone
}

/// In a containment: past the nearest of the outer polygon's edges.
Exit ComponentExits::byNearestEdge(const OverlapComponent& component) const {
  const int inner = leftmostOf(component).edge[1] != kNoEdge ? 1 : 0, outer = 1 - inner;
  // Only the inner polygon is searched from, so that many components don't cost their number squared.
  const Polygon own_rings = ringsOf(component, inner);
  const PolygonData &inside = dataOf(own_rings), &outside = polygonOf(pair_, outer);
  // Edges of the component's own rings are no way out of it, unless the component is all around a complement's hole.
  std::unordered_set<EdgePosition> own;
  for (const BoundaryPoint& point : component.points)
    if (point.edge[outer] != kNoEdge && !outside.fill.is_complement) own.insert(point.edge[outer]);
  double nearest = std::numeric_limits<double>::infinity();
  // Beyond the range of squares, any edge will do.
  Vec2 in = leftmostOf(component).at, out = frame_.from(outer, outside.path.front()), across = Vec2::UnitX();
  const auto tryEdges = [&](EdgePosition i, EdgePosition o) {
    if (own.count(o) != 0) return;
    const WorldFrame::Ends edge{frame_.from(inner, inside.path[i]), frame_.from(inner, inside.path[i + 1])},
        outer_edge = frame_.edgeEnds(outer, o);
    const auto [on_inner, on_outer] = nearestPlaces(edge, outer_edge);
    const double distance = (on_outer - on_inner).norm();
    if (!(distance < nearest)) return;
    nearest = distance;
    in = on_inner;
    out = on_outer;
    const Vec2 way = outer_edge.w - outer_edge.v;
    if (!way.isZero(0)) across = Vec2(way.y(), -way.x()).stableNormalized();
  };
  const double far = 4 * std::min(pair_.a.reach + pair_.b.reach, 0x1p1020);
  const PosedPair pair(inside, poseOf(pair_, inner), outside, poseOf(pair_, outer));
  const bool is_inner_first = inside.unit > outside.unit;
  forEachPair(is_inner_first ? pair : pair.back(), far, [&](double, EdgePosition i, EdgePosition j) {
    tryEdges(is_inner_first ? i : j, is_inner_first ? j : i);
    return std::min(far, (nearest + frame_.error()) * frame_.unit());
  });
  Vec2 outwards = across;
  if (nearest > 4 * frame_.error())
    outwards = (out - in).stableNormalized();
  else if (across.dot(out - (inner == 1 ? Vec2(Vec2::Zero()) : frame_.originOfA())) < 0)
    outwards = -across;
  Exit exit{inner == 1 ? outwards : Vec2(-outwards), 0, {kNoEdge, kNoEdge}, outer};
  // Beside a reflex corner the rings may reach farther than the nearest edge: then they are to pass their own length.
  double farthest = outwards.dot(out);
  for (const BoundaryPoint& point : component.points) farthest = std::max(farthest, outwards.dot(point.at));
  for (const BoundaryPoint& point : component.points) {
    const double depth = farthest - outwards.dot(point.at);
    if (depth < exit.depth) continue;
    exit.depth = depth;
    for (const int side : {0, 1}) exit.edges[side] = flatter(side, point, outwards);
  }
  return exit;
}

}  // namespace tricover::detail
