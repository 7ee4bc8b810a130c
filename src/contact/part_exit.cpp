// SPDX-License-Identifier: BSD-3-Clause
#include "contact/part_exit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_set>
#include <utility>

#include "contact/contact_ends.h"
#include "contact/convex_penetration.h"
#include "contact/touch_normal.h"
#include "numbers/segment.h"
#include "pair/edge_pairs.h"

namespace tricover::detail {
namespace {

/// The edge of a polygon that two points are on; -1 if there is none.
std::ptrdiff_t common(std::ptrdiff_t p, std::ptrdiff_t p_before, std::ptrdiff_t q, std::ptrdiff_t q_before) {
  if (p >= 0 && (p == q || p == q_before)) return p;
  if (p_before >= 0 && (p_before == q || p_before == q_before)) return p_before;
  return -1;
}
std::ptrdiff_t commonOfA(const BoundaryPoint& p, const BoundaryPoint& q) {
  return common(p.a, p.a_before, q.a, q.a_before);
}
std::ptrdiff_t commonOfB(const BoundaryPoint& p, const BoundaryPoint& q) {
  return common(p.b, p.b_before, q.b, q.b_before);
}

}  // namespace

/// Of a containment it is a vertex of what is inside.
const BoundaryPoint& leftmostOf(const OverlapComponent& component) {
  return *std::min_element(component.points.begin(), component.points.end(),
                           [](const BoundaryPoint& p, const BoundaryPoint& q) { return p.at.x() < q.at.x(); });
}

Exit PartExits::exitOf(const OverlapComponent& component) {
  if (component.crossings.empty()) return byNearestEdge(component);
  if (!component.inner) return ofTouch(component);
  const Exit exit = byFaces(component);
  // All of it may be one rounded point.
  return exit.depth < std::numeric_limits<double>::infinity() ? exit : ofTouch(component);
}

/// Of ways that are equally deep but for rounding, the one that leads b's origin away from a's.
bool PartExits::isBetter(const Exit& exit, const Exit& best) const {
  const double error = 4 * frame_.error();
  return exit.depth < best.depth - error ||
         (exit.depth <= best.depth + error && exit.normal.dot(towards_b_) > best.normal.dot(towards_b_));
}

std::ptrdiff_t PartExits::flatterOfA(const BoundaryPoint& p, const Vec2& normal) const {
  return flatterEdge(p.a, p.a_before, normal, [this](std::size_t e) { return frame_.edgeEndsOfA(e); });
}
std::ptrdiff_t PartExits::flatterOfB(const BoundaryPoint& p, const Vec2& normal) const {
  return flatterEdge(p.b, p.b_before, normal, [this](std::size_t e) { return frame_.edgeEndsOfB(e); });
}

Exit PartExits::exitOfConvex(const OverlapComponent& component, const SeparatingAxes& axes) const {
  const SupportGap gap = leastSupportGap(pair_, &axes, 4 * frame_.error() * frame_.unit());
  const PolygonData &own = gap.edge_of_a ? pair_.a : pair_.b, &other = gap.edge_of_a ? pair_.b : pair_.a;
  const std::size_t corner = convexOutlineOf(other).corners[gap.corner];
  const BoundaryPoint deepest = gap.edge_of_a ? vertexOfB(corner) : vertexOfA(corner);
  const Vec2 in_own = gap.edge_of_a ? frame_.toA(deepest.at) : frame_.toB(deepest.at);
  const auto edge = static_cast<std::ptrdiff_t>(pathEdge(own, convexOutlineOf(own), gap.edge, in_own));
  Exit exit{gap.normal, gap.depth / frame_.unit(), edge, edge, gap.edge_of_a};
  if (gap.edge_of_a)
    exit.edge_b = flatterOfB(deepest, gap.normal);
  else
    exit.edge_a = flatterOfA(deepest, gap.normal);
  if (component.crossings.empty()) (component.points.front().a < 0 ? exit.edge_a : exit.edge_b) = -1;
  return exit;
}

/// The hull of the part and of the edges of one side that cross there.
Hull PartExits::grownPart(const OverlapComponent& component, bool of_a) const {
  const PolygonData& polygon = of_a ? pair_.a : pair_.b;
  const auto forEachEnd = [&](auto visit) {
    for (const std::size_t k : component.crossings) {
      const std::size_t edge = of_a ? crossings_[k].edge_a : crossings_[k].edge_b;
      for (const std::size_t v : {edge, edgeAfter(polygon, edge)})
        visit(v, of_a ? frame_.fromA(polygon.path[v]) : frame_.fromB(polygon.path[v]));
    }
  };
  const auto pointOf = [&](std::size_t v, const Vec2& at) { return vertexPoint(polygon, of_a ? 0 : 1, v, at); };
  Hull grown = part_;
  if (grown.size() > 2)
    forEachEnd([&](std::size_t v, const Vec2& at) { addToHull(grown, at, [&] { return pointOf(v, at); }); });
  if (turnsLeft(grown)) return grown;
  grown = part_;
  forEachEnd([&](std::size_t v, const Vec2& at) { grown.push_back(pointOf(v, at)); });
  return detail::hullOf(std::move(grown));
}

/// Of the faces that are edges, or of the others.
PartExits::Found PartExits::leastFace(bool is_edge) const {
  Found best;
  const auto offer = [&](const Exit& exit, const BoundaryPoint& from, const BoundaryPoint& to,
                         const BoundaryPoint& deepest) {
    if (isBetter(exit, best.exit)) best = {exit, &from, &to, &deepest};
  };
  forEachFace(
      grown_[0], grown_[1], [&](auto& from, auto& to) { return (commonOfA(from, to) >= 0) == is_edge; },
      [&](auto& from, auto& to, const Vec2& normal, double depth, auto& deepest) {
        offer({normal, depth, -1, -1, true}, from, to, deepest);
      });
  forEachFace(
      grown_[1], grown_[0], [&](auto& from, auto& to) { return (commonOfB(from, to) >= 0) == is_edge; },
      [&](auto& from, auto& to, const Vec2& normal, double depth, auto& deepest) {
        offer({-normal, depth, -1, -1, false}, from, to, deepest);
      });
  return best;
}

/// As if this part of the overlap and the edges around it were all there is: by the faces of their hulls that are
/// edges, or by any faces if none is.
Exit PartExits::byFaces(const OverlapComponent& component) {
  grown_[0] = grownPart(component, true);
  grown_[1] = grownPart(component, false);
  Found found = leastFace(true);
  if (!(found.exit.depth < std::numeric_limits<double>::infinity())) found = leastFace(false);
  Exit& exit = found.exit;
  if (!(exit.depth < std::numeric_limits<double>::infinity())) return exit;
  exit.edge_a = exit.from_a ? commonOfA(*found.from, *found.to) : flatterOfA(*found.deepest, exit.normal);
  exit.edge_b = exit.from_a ? flatterOfB(*found.deepest, exit.normal) : commonOfB(*found.from, *found.to);
  // What is deepest may be a vertex of the other polygon.
  if (exit.edge_a < 0 || exit.edge_b < 0) completeEdges(component, exit);
  return exit;
}

void PartExits::completeEdges(const OverlapComponent& component, Exit& exit) const {
  const bool needs_a = exit.edge_a < 0, needs_b = exit.edge_b < 0;
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const BoundaryPoint& point : component.points) {
    const double height = exit.normal.dot(point.at);
    if (needs_b && point.b >= 0 && height <= lowest) {
      lowest = height;
      exit.edge_b = point.b;
    }
    if (needs_a && point.a >= 0 && height >= highest) {
      highest = height;
      exit.edge_a = point.a;
    }
  }
}

Exit PartExits::ofTouch(const OverlapComponent& component) const {
  const EdgeCrossing& main = crossings_[longestStretch(frame_, crossings_, component)];
  return {touchNormal(frame_, crossings_, component, main, towards_b_), 0, static_cast<std::ptrdiff_t>(main.edge_a),
          static_cast<std::ptrdiff_t>(main.edge_b), true};
}

/// The rings that a containment is made of, as a polygon of their own.
Polygon PartExits::ringsOf(const OverlapComponent& component, bool of_b) const {
  const PolygonData& polygon = of_b ? pair_.b : pair_.a;
  std::vector<Ring> rings;
  std::size_t last = polygon.ringCount();
  for (const BoundaryPoint& point : component.points) {
    const std::ptrdiff_t edge = of_b ? point.b : point.a;
    if (edge < 0) continue;
    const std::size_t ring = polygon.ringOf(static_cast<std::size_t>(edge));
    if (ring != last) rings.push_back(polygon.vertices(ring));
    last = ring;
  }
  return Polygon(rings, polygon.fill);
}

/// In a containment: past the nearest of the outer polygon's edges.
Exit PartExits::byNearestEdge(const OverlapComponent& component) const {
  const BoundaryPoint& leftmost = leftmostOf(component);
  const bool b_inside = leftmost.b >= 0;
  // Only what is inside is searched from, so that many parts don't cost their number squared.
  const Polygon own_rings = ringsOf(component, b_inside);
  const PolygonData &inside = own_rings.data(), &outside = b_inside ? pair_.a : pair_.b;
  const Pose &pose_inside = b_inside ? pair_.pose_b : pair_.pose_a,
             &pose_outside = b_inside ? pair_.pose_a : pair_.pose_b;
  // Edges of the component's own rings are no way out of it.
  std::unordered_set<std::size_t> own;
  for (const BoundaryPoint& point : component.points) {
    const std::ptrdiff_t edge = b_inside ? point.a : point.b;
    if (edge >= 0) own.insert(static_cast<std::size_t>(edge));
  }
  double nearest = std::numeric_limits<double>::infinity();
  Vec2 in = leftmost.at, out = in;
  Vec2 across = Vec2::UnitX();
  const auto tryPoints = [&](const Vec2& inner, const Vec2& outer, const WorldFrame::Ends& outer_edge) {
    const double distance = (outer - inner).norm();
    if (!(distance < nearest)) return;
    nearest = distance;
    in = inner;
    out = outer;
    const Vec2 way = outer_edge.w - outer_edge.v;
    if (!way.isZero(0)) across = Vec2(way.y(), -way.x()).stableNormalized();
  };
  const auto tryEdges = [&](std::size_t i, std::size_t o) {
    const Vec2 &v = inside.path[i], &w = inside.path[i + 1];
    const WorldFrame::Ends inner = b_inside ? WorldFrame::Ends{frame_.fromB(v), frame_.fromB(w)}
                                            : WorldFrame::Ends{frame_.fromA(v), frame_.fromA(w)},
                           outer = b_inside ? frame_.edgeEndsOfA(o) : frame_.edgeEndsOfB(o);
    for (const Vec2& p : {inner.v, inner.w}) tryPoints(p, nearestOnSegment(p, outer.v, outer.w), outer);
    for (const Vec2& q : {outer.v, outer.w}) tryPoints(nearestOnSegment(q, inner.v, inner.w), q, outer);
  };
  const double far = 4 * std::min(pair_.a.radius + pair_.b.radius, 0x1p1020);
  const auto search = [&](const PosedPair& pair, bool inside_first) {
    forEachPair(pair, far, [&](double, std::size_t i, std::size_t j) {
      if (own.count(inside_first ? j : i) == 0) inside_first ? tryEdges(i, j) : tryEdges(j, i);
      return std::min(far, (nearest + frame_.error()) * frame_.unit());
    });
  };
  if (inside.unit > outside.unit)
    search(PosedPair(inside, pose_inside, outside, pose_outside), true);
  else
    search(PosedPair(outside, pose_outside, inside, pose_inside), false);
  Exit exit;
  Vec2 outwards = across;
  if (nearest > 4 * frame_.error())
    outwards = (out - in).normalized();
  else if (across.dot(out - (b_inside ? Vec2(Vec2::Zero()) : frame_.originOfA())) < 0)
    outwards = -across;
  exit.depth = 0;
  for (const BoundaryPoint& point : component.points) {
    const double depth = outwards.dot(out - point.at);
    if (depth < exit.depth) continue;
    exit.depth = depth;
    exit.edge_a = flatterOfA(point, outwards);
    exit.edge_b = flatterOfB(point, outwards);
  }
  exit.normal = b_inside ? outwards : Vec2(-outwards);
  exit.from_a = b_inside;
  return exit;
}

}  // namespace tricover::detail
