// SPDX-License-Identifier: BSD-3-Clause
// The overlap's boundary consists of arcs of either polygon that lie in the other one, and its nodes are the crossings.
// Nodes and arcs are joined along every ring; a polygon's own crossings join its arcs, too. What hangs together then is
// either the outer boundary of a component or a hole's, and a hole belongs to what is next to it on any side.
// On the way along a ring every crossing changes the other polygon's winding number by one, so that as a rule one
// vertex of a ring is located, not one of every arc: that may cost O(n) each, as in combs.
#include "contact/overlap_arcs.h"

#include <algorithm>

#include "overlay/rings.h"

namespace tricover::detail {

void OverlapArcs::join(bool with_own_crossings) {
  const std::size_t about = crossings_.size() + pair_.a.ringCount() + pair_.b.ringCount();
  sets_ = UnionFind();
  sets_.reserve(about);
  nodes_.clear();
  nodes_.reserve(about);
  arcs_.clear();
  arcs_.reserve(about);
  for (Side& side : sides_) {
    side.stops.clear();
    side.stops.reserve(crossings_.size());
  }
  rings_.assign(pair_.a.ringCount() + pair_.b.ringCount(), {});
  sides_[0].rings = rings_.data();
  sides_[1].rings = rings_.data() + pair_.a.ringCount();
  for (const EdgeCrossing& c : crossings_) {
    const std::size_t node = addNode(true);
    const bool known = c.direction != 0;
    for (const int side : {0, 1})
      sides_[side].stops.push_back(
          {c.edge[side], c.on[side], node, {known, side == 0 ? -c.direction : c.direction}, false});
  }
  for (int side : {0, 1}) {
    if (with_own_crossings) addOwnCrossings(side);
    joinAlongRings(side);
  }
}

std::size_t OverlapArcs::addNode(bool present) {
  nodes_.push_back({present, false, kNone});
  return sets_.add();
}

void OverlapArcs::addOwnCrossings(int side) {
  addRepeatedVertices(side);
  forEachOwnCrossing(sides_[side].polygon, [&](EdgePosition e, EdgePosition f) {
    addOwnCrossing(side, e, f);
    return true;
  });
}

/// A node for each point that several vertices are at: however many edges end there, it takes no pairs of them.
void OverlapArcs::addRepeatedVertices(int side) {
  Side& own = sides_[side];
  const Path& path = own.polygon.path;
  const std::vector<std::uint32_t> order = verticesByPlace(own.polygon);
  for (std::size_t k = 0, next = 0; k < order.size(); k = next) {
    while (next < order.size() && path[order[next]] == path[order[k]]) ++next;
    if (next - k < 2) continue;
    const std::size_t node = addNode(false);
    for (std::size_t i = k; i < next; ++i) {
      own.stops.push_back({order[i], {0, 0}, node, {true, 0}, false});
      own.stops.push_back({edgeBefore(own.polygon, order[i]), {1, 1}, node, {true, 0}, false});
    }
  }
}

/// Two nodes, where they cover each other: what is between needn't be in the overlap.
void OverlapArcs::addOwnCrossing(int side, EdgePosition e, EdgePosition f) {
  Side& own = sides_[side];
  const Ends of_e = ends(side, e), of_f = ends(side, f);
  const Span on_e = spanNear(of_e, of_f, frame_.error()), on_f = spanNear(of_f, of_e, frame_.error());
  const bool alike = (of_e.w - of_e.v).dot(of_f.w - of_f.v) > 0;
  const double ends_on_e[] = {on_e.low, on_e.high};
  const double ends_on_f[] = {alike ? on_f.low : on_f.high, alike ? on_f.high : on_f.low};
  for (int end : {0, 1}) {
    const std::size_t node = addNode(false);
    own.stops.push_back({e, {ends_on_e[end], ends_on_e[end]}, node, {true, 0}, false});
    own.stops.push_back({f, {ends_on_f[end], ends_on_f[end]}, node, {true, 0}, false});
  }
}

void OverlapArcs::joinAlongRings(int side) {
  Side& own = sides_[side];
  std::pmr::vector<Stop>& stops = own.stops;
  std::sort(stops.begin(), stops.end(),
            [](const Stop& s, const Stop& t) { return s.edge != t.edge ? s.edge < t.edge : s.span.low < t.span.low; });
  std::size_t begin = 0;
  for (std::size_t r = 0; r < own.polygon.ringCount(); ++r) {
    std::size_t end = begin;
    bool crossed = false;
    for (; end < stops.size() && stops[end].edge < own.polygon.edgeEnd(r); ++end)
      crossed = crossed || stops[end].node < crossings_.size();
    own.rings[r].begin = begin;
    own.rings[r].end = end;
    if (crossed)
      joinArcs(side, begin, end);
    else if (includeVertex(side, own.polygon.edgeBegin(r)).location != Location::Outside)
      joinWhole(side, r);
    begin = end;
  }
}

/// A ring that no edge of the other polygon meets, in the other's region.
void OverlapArcs::joinWhole(int side, std::size_t r) {
  Side& own = sides_[side];
  const std::size_t node = addNode(true);
  nodes_[node].is_inner = true;
  own.rings[r].node = static_cast<std::ptrdiff_t>(node);
  for (std::size_t k = own.rings[r].begin; k < own.rings[r].end; ++k) sets_.join(own.stops[k].node, node);
  arcs_.push_back({side, own.polygon.edgeBegin(r), own.polygon.edgeEnd(r) - 1, node});
}

void OverlapArcs::joinArcs(int side, std::size_t begin, std::size_t end) {
  std::pmr::vector<Stop>& stops = sides_[side].stops;
  Winding winding;  // the other's, on the arc after the stop
  double reach = 0;
  // Beginning with the way round from the last stop to the first, which tells the winding number.
  for (std::size_t k = end - 1, next = begin; next < end; k = next++) {
    Stop& stop = stops[k];
    winding.pass(stop.change);
    const bool on_edge = k < next && stop.edge == stops[next].edge;
    stop.joined = on_edge ? joinedOnEdge(side, stop, stops[next], reach, winding)
                          : joinedRoundVertices(side, stop, stops[next], winding);
    reach = on_edge ? std::max(reach, stops[next].span.high) : stops[next].span.high;
    if (stop.joined) sets_.join(stop.node, stops[next].node);
  }
}

bool OverlapArcs::joinedOnEdge(int side, const Stop& stop, const Stop& next, double reach, const Winding& winding) {
  const Ends edge = ends(side, stop.edge);
  const Vec2 way = edge.w - edge.v;
  if ((next.span.low - reach) * way.norm() <= 4 * frame_.error()) return true;
  const bool in = winding.known ? sides_[1 - side].isInside(winding.number)
                                : holds(1 - side, edge.v + somewhere({reach, next.span.low}) * way);
  if (in) nodes_[stop.node].is_inner = true;
  return in;
}

/// No vertex between two stops in a row is on the other's boundary, unless it is both of them, so that one stands for
/// all.
bool OverlapArcs::joinedRoundVertices(int side, const Stop& stop, const Stop& next, Winding& winding) {
  const Side& own = sides_[side];
  const EdgePosition v = edgeAfter(own.polygon, stop.edge);
  if (!winding.known) {
    const Inclusion found = includeVertex(side, v);
    if (found.location == Location::Boundary) return true;
    winding = {true, found.winding};
  }
  if (!sides_[1 - side].isInside(winding.number)) return false;
  nodes_[stop.node].is_inner = nodes_[stop.node].is_present = true;
  arcs_.push_back({side, v, next.edge, stop.node});
  return true;
}

}  // namespace tricover::detail
