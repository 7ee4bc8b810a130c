// SPDX-License-Identifier: BSD-3-Clause
// The overlap's boundary consists of arcs of either polygon that lie in the other one, and its nodes are the crossings.
// Nodes and arcs are joined along every ring; a polygon's own crossings join its arcs, too. What hangs together then is
// either the outer boundary of a component or a hole's, and a hole belongs to what is next to it on any side.
// On the way along a ring every crossing changes the other polygon's winding number by one, so that as a rule one
// vertex of a ring is located, not one of every arc: that may cost O(n) each, as in combs.
#include "contact/overlap_components.h"

#include <algorithm>
#include <limits>

#include "contact/boundary_ray.h"
#include "contact/own_crossings.h"
#include "hierarchy/inclusion.h"
#include "numbers/segment.h"
#include "numbers/union_find.h"

namespace tricover::detail {
namespace {

/// A winding number or a change of one, where that is known.
struct Winding {
  bool known = false;
  int number = 0;
};

/// Where a node is on a ring.
struct Stop {
  std::size_t edge;
  Span span;
  std::size_t node;
  /// By how much the other's winding number changes here; none if it may do anything, as where edges touch.
  Winding change;
  bool joined;  ///< the arc from here to the next stop is in the other region
};

/// One polygon's boundary, as the nodes divide it.
struct Side {
  struct RingStops {
    std::size_t begin = 0, end = 0;  ///< in `stops`
    std::ptrdiff_t node = -1;        ///< of a ring that lies in the other region as a whole; otherwise -1
    /// The own winding number along its left, all along the ring, if that is known.
    Winding left;
    bool meets_own = false;  ///< or other rings of its polygon: then it isn't the same all along
  };

  explicit Side(const PolygonData& polygon_) : polygon(polygon_) {}

  std::size_t after(std::size_t edge) const { return edgeAfter(polygon, edge); }
  bool isInside(int winding) const { return detail::isInside(polygon.fill, winding); }

  const PolygonData& polygon;
  std::vector<Stop> stops;  ///< by edge, then where they begin
  std::vector<RingStops> rings;
};

/// Off the middle, where symmetric shapes have other edges, too.
double somewhere(const Span& span) { return span.low + 0.4142 * (span.high - span.low); }

/// Vertices of a ring that lie in the other region, from one to another, all around.
struct Arc {
  int side;
  std::size_t from, to;
  std::size_t node;
};

/// A crossing, or a vertex of an arc.
struct NodePoint {
  std::size_t node;
  int side;        ///< kCrossing, or whose vertex it is
  std::size_t at;  ///< its index, or the vertex's position
  static constexpr int kCrossing = -1;
};

class Grouping {
 public:
  Grouping(const PosedPair& pair, const WorldFrame& frame, const std::vector<EdgeCrossing>& crossings)
      : pair_(pair),
        swapped_(pair.b, pair.pose_b, pair.a, pair.pose_a),
        frame_(frame),
        crossings_(crossings),
        sides_{Side(pair.a), Side(pair.b)} {}

  std::vector<OverlapComponent> components(ContactDetail detail) {
    join(false);
    std::size_t count = countSets();
    // A polygon's own crossings cost a descent of it, and matter only if there is something left to join.
    if (count > 1 && (meetsItself(pair_.a) || meetsItself(pair_.b))) {
      join(true);
      count = countSets();
    }
    if (count > 1) joinHoles();
    return collect(detail != ContactDetail::Points);
  }

 private:
  using Ends = WorldFrame::Ends;

  Vec2 vertex(int side, std::size_t v) const {
    const Vec2& local = sides_[side].polygon.path[v];
    return side == 0 ? frame_.fromA(local) : frame_.fromB(local);
  }
  Ends ends(int side, std::size_t e) const { return side == 0 ? frame_.edgeEndsOfA(e) : frame_.edgeEndsOfB(e); }

  /// Where one side's vertex is in the other's region, and how that winds around it in the world. Exact.
  Inclusion includeVertex(int side, std::size_t v) const {
    const PosedPair& pair = side == 0 ? swapped_ : pair_;
    const Vec2& local = pair.b.path[v];
    const Inclusion found =
        includeInPolygon(pair.a, {&pair.pose_a, pair.fromB(local), {&pair.pose_b, local}, pair.handed});
    return {found.location, found.winding * pair.handed};
  }

  bool holds(int side, const Vec2& p) const { return detail::holds(pair_, frame_, side, p); }

  void join(bool with_own_crossings) {
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
      side.rings.assign(side.polygon.ringCount(), {});
    }
    for (const EdgeCrossing& c : crossings_) {
      const std::size_t node = addNode(true);
      const bool known = c.direction != 0;
      sides_[0].stops.push_back({c.edge_a, c.on_a, node, {known, -c.direction}, false});
      sides_[1].stops.push_back({c.edge_b, c.on_b, node, {known, c.direction}, false});
    }
    for (int side : {0, 1}) {
      if (with_own_crossings) addOwnCrossings(side);
      joinAlongRings(side);
    }
  }

  std::size_t addNode(bool present) {
    nodes_.push_back({present, false, false, 0});
    return sets_.add();
  }

  void addOwnCrossings(int side) {
    const std::ptrdiff_t star = addRepeatedVertices(side);
    forEachOwnCrossing(sides_[side].polygon, star, [&](std::size_t e, std::size_t f) {
      addOwnCrossing(side, e, f);
      return true;
    });
  }

  /// A node for each point that several vertices are at: however many edges end there, it takes no pairs of them.
  /// One of the vertices where many are, or -1.
  std::ptrdiff_t addRepeatedVertices(int side) {
    constexpr std::size_t kMany = 32;
    std::ptrdiff_t star = -1;
    std::size_t most = kMany;
    Side& own = sides_[side];
    const Path& path = own.polygon.path;
    const std::vector<std::uint32_t> order = verticesByPlace(own.polygon);
    for (std::size_t k = 0, next = 0; k < order.size(); k = next) {
      while (next < order.size() && path[order[next]] == path[order[k]]) ++next;
      if (next - k < 2) continue;
      if (next - k > most) star = static_cast<std::ptrdiff_t>(order[k]);
      most = std::max(most, next - k);
      const std::size_t node = addNode(false);
      for (std::size_t i = k; i < next; ++i) {
        own.rings[own.polygon.ringOf(order[i])].meets_own = true;
        own.stops.push_back({order[i], {0, 0}, node, {true, 0}, false});
        own.stops.push_back({edgeBefore(own.polygon, order[i]), {1, 1}, node, {true, 0}, false});
      }
    }
    return star;
  }

  /// Two nodes, where they cover each other: what is between needn't be in the overlap.
  void addOwnCrossing(int side, std::size_t e, std::size_t f) {
    Side& own = sides_[side];
    own.rings[own.polygon.ringOf(e)].meets_own = own.rings[own.polygon.ringOf(f)].meets_own = true;
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

  void joinAlongRings(int side) {
    Side& own = sides_[side];
    std::vector<Stop>& stops = own.stops;
    std::sort(stops.begin(), stops.end(), [](const Stop& s, const Stop& t) {
      return s.edge != t.edge ? s.edge < t.edge : s.span.low < t.span.low;
    });
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
  void joinWhole(int side, std::size_t r) {
    Side& own = sides_[side];
    const std::size_t node = addNode(true);
    nodes_[node].is_inner = true;
    own.rings[r].node = static_cast<std::ptrdiff_t>(node);
    for (std::size_t k = own.rings[r].begin; k < own.rings[r].end; ++k) sets_.join(own.stops[k].node, node);
    arcs_.push_back({side, own.polygon.edgeBegin(r), own.polygon.edgeEnd(r) - 1, node});
  }

  /// Of nodes that are wanted, crossings first. Of a repeated vertex the last one stands for all.
  template <typename Wanted, typename Visit>
  void forEachPoint(Wanted isWanted, Visit visit) const {
    for (std::size_t k = 0; k < crossings_.size(); ++k)
      if (isWanted(k)) visit(NodePoint{k, NodePoint::kCrossing, k});
    for (const Arc& arc : arcs_) {
      if (!isWanted(arc.node)) continue;
      const PolygonData& polygon = sides_[arc.side].polygon;
      const std::size_t ring = polygon.ringOf(arc.from), begin = polygon.edgeBegin(ring), end = polygon.edgeEnd(ring);
      for (std::size_t v = arc.from;; v = v + 1 < end ? v + 1 : begin) {
        if (polygon.path[v] != polygon.path[v + 1] || isPoint(polygon, v)) visit(NodePoint{arc.node, arc.side, v});
        if (v == arc.to) break;
      }
    }
  }

  BoundaryPoint boundaryPoint(const NodePoint& point) const {
    if (point.side != NodePoint::kCrossing)
      return vertexPoint(sides_[point.side].polygon, point.side, point.at, vertex(point.side, point.at));
    const EdgeCrossing& c = crossings_[point.at];
    const auto i = static_cast<std::int32_t>(c.edge_a), j = static_cast<std::int32_t>(c.edge_b);
    return {c.point, i, i, j, j};
  }

  /// Whether v begins a ring that is one point.
  static bool isPoint(const PolygonData& polygon, std::size_t v) {
    const std::size_t ring = polygon.ringOf(v);
    if (v != polygon.edgeBegin(ring)) return false;
    const auto begin = polygon.path.begin() + static_cast<std::ptrdiff_t>(v);
    return std::all_of(begin, polygon.path.begin() + static_cast<std::ptrdiff_t>(polygon.edgeEnd(ring)),
                       [&](const Vec2& p) { return p == *begin; });
  }

  void joinArcs(int side, std::size_t begin, std::size_t end) {
    std::vector<Stop>& stops = sides_[side].stops;
    Winding winding;  // the other's, on the arc after the stop
    double reach = 0;
    // Beginning with the way round from the last stop to the first, which tells the winding number.
    for (std::size_t k = end - 1, next = begin; next < end; k = next++) {
      Stop& stop = stops[k];
      pass(1 - side, stop, winding);
      const bool on_edge = k < next && stop.edge == stops[next].edge;
      stop.joined = on_edge ? joinedOnEdge(side, stop, stops[next], reach, winding)
                            : joinedRoundVertices(side, stop, stops[next], winding);
      reach = on_edge ? std::max(reach, stops[next].span.high) : stops[next].span.high;
      if (stop.joined) sets_.join(stop.node, stops[next].node);
    }
  }

  /// Takes the other side's winding number past a stop; on the way it is the one along the left of the edge crossed.
  void pass(int other, const Stop& stop, Winding& winding) {
    winding.known = winding.known && stop.change.known;
    if (!winding.known) return;
    const int before = winding.number;
    winding.number += stop.change.number;
    if (stop.node < crossings_.size()) {
      const EdgeCrossing& crossing = crossings_[stop.node];
      Side& crossed = sides_[other];
      const std::size_t ring = crossed.polygon.ringOf(other == 0 ? crossing.edge_a : crossing.edge_b);
      crossed.rings[ring].left = {true, std::max(before, winding.number)};
    }
  }

  bool joinedOnEdge(int side, const Stop& stop, const Stop& next, double reach, const Winding& winding) {
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
  bool joinedRoundVertices(int side, const Stop& stop, const Stop& next, Winding& winding) {
    const Side& own = sides_[side];
    const std::size_t v = own.after(stop.edge);
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

  std::size_t countSets() {
    for (Node& node : nodes_) node.is_counted = false;
    std::size_t count = 0;
    for (std::size_t k = 0; k < sets_.size(); ++k) {
      if (!nodes_[k].is_present) continue;
      Node& root = nodes_[sets_.find(k)];
      count += !root.is_counted;
      root.is_counted = true;
    }
    return count;
  }

  void joinHoles() {
    struct Leftmost {
      bool is_known = false;
      NodePoint point;
      Vec2 at;
    };
    std::vector<Leftmost> leftmost(sets_.size());
    const auto all = [](std::size_t) { return true; };
    forEachPoint(all, [&](const NodePoint& point) {
      Leftmost& best = leftmost[sets_.find(point.node)];
      const Vec2 at = leftEnd(point);
      if (!best.is_known || at.x() < best.at.x()) best = {true, point, at};
    });
    for (const Leftmost& best : leftmost) {
      if (!best.is_known || !overlapsLeftOf(best.point, best.at)) continue;
      const std::ptrdiff_t node = leftOf(best.at);
      if (node >= 0) sets_.join(best.point.node, static_cast<std::size_t>(node));
    }
  }

  /// Of a common stretch of two edges the end on the left, beyond which they needn't be both.
  Vec2 leftEnd(const NodePoint& point) const {
    if (point.side != NodePoint::kCrossing) return vertex(point.side, point.at);
    const EdgeCrossing& crossing = crossings_[point.at];
    if (crossing.direction != 0) return crossing.point;
    const Vec2 low = frame_.edgeOfA(crossing.edge_a, crossing.on_a.low),
               high = frame_.edgeOfA(crossing.edge_a, crossing.on_a.high);
    return low.x() < high.x() ? low : high;
  }

  /// Whether what is next to the leftmost point of a boundary, outside of it, is in the overlap.
  bool overlapsLeftOf(const NodePoint& point, const Vec2& at) const {
    // Where edges cross, a corner of the overlap is less than a half turn: here to the right.
    if (point.side == NodePoint::kCrossing) {
      if (crossings_[point.at].direction != 0) return false;
    } else {
      const int side = point.side;
      const BoundaryPoint p = boundaryPoint(point);
      const auto edge = static_cast<std::size_t>(side == 0 ? p.a : p.b),
                 before = static_cast<std::size_t>(side == 0 ? p.a_before : p.b_before);
      const Side& own = sides_[side];
      const Side::RingStops& ring = own.rings[own.polygon.ringOf(edge)];
      // Both edges lead to the right: their turn tells whether the ring's left side is around the back of them.
      const Ends to = ends(side, edge), from = ends(side, before);
      const double turn = cross(from.v - from.w, to.w - to.v);
      if (ring.left.known && !ring.meets_own && turn != 0)
        return own.isInside(turn > 0 ? ring.left.number : ring.left.number - 1);
    }
    const Vec2 beside = at - Vec2(4 * frame_.error(), 0);
    return holds(0, beside) && holds(1, beside);
  }

  /// The node of the boundary that is next to the left; -1 if none is found.
  std::ptrdiff_t leftOf(const Vec2& p) const {
    // Farther and farther, so that it costs what is near.
    for (double length = 0x1p-12;; length = length < 0x1p12 ? 8 * length : std::numeric_limits<double>::infinity()) {
      Hit hit{-std::numeric_limits<double>::infinity(), -1};
      const double right = p.x() - 4 * frame_.error();
      for (const int side : {0, 1})
        forEachEdgeOnRay(pair_, frame_, side, p, Vec2(-1, 0), length, [&](std::size_t edge) {
          addHit(side, edge, p.y(), right, hit);
          return std::min(length, p.x() - hit.x);
        });
      if (!(p.x() - hit.x > length)) return hit.node;
    }
  }

  struct Hit {
    double x;
    std::ptrdiff_t node;
  };

  void addHit(int side, std::size_t edge, double y, double right, Hit& hit) const {
    const auto [v, w] = ends(side, edge);
    if (y < std::min(v.y(), w.y()) || y > std::max(v.y(), w.y())) return;
    const double t = v.y() != w.y() ? (y - v.y()) / (w.y() - v.y()) : v.x() < w.x() ? 1 : 0;
    const double x = v.x() + t * (w.x() - v.x());
    if (x > right || x < hit.x) return;
    const std::ptrdiff_t node = nodeAt(side, edge, t);
    if (x == hit.x && node < 0) return;
    hit = {x, node};
  }

  /// A node that the point t of an edge is joined to; -1 if it isn't in the other region.
  std::ptrdiff_t nodeAt(int side, std::size_t edge, double t) const {
    const Side& own = sides_[side];
    const Side::RingStops& ring = own.rings[own.polygon.ringOf(edge)];
    if (ring.node >= 0 || ring.begin == ring.end) return ring.node;
    const auto begin = own.stops.begin() + static_cast<std::ptrdiff_t>(ring.begin);
    const auto end = own.stops.begin() + static_cast<std::ptrdiff_t>(ring.end);
    const auto next = std::partition_point(
        begin, end, [&](const Stop& stop) { return stop.edge != edge ? stop.edge < edge : stop.span.low <= t; });
    const Stop& stop = *((next == begin ? end : next) - 1);
    const bool on_stop = next != begin && stop.edge == edge && t <= stop.span.high;
    return stop.joined || on_stop ? static_cast<std::ptrdiff_t>(stop.node) : -1;
  }

  std::vector<OverlapComponent> collect(bool wants_all) {
    std::vector<OverlapComponent> result;
    const auto of = [&](std::size_t node) -> OverlapComponent& { return result[nodes_[sets_.find(node)].component]; };
    for (Node& node : nodes_) node.is_counted = false;
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      Node& root = nodes_[sets_.find(k)];
      if (!nodes_[k].is_present || root.is_counted) continue;
      root.is_counted = true;
      root.component = result.size();
      result.emplace_back();
    }
    if (result.size() == 1) {
      result[0].crossings.reserve(crossings_.size());
      result[0].points.reserve(crossings_.size() + (wants_all ? 16 * arcs_.size() : 0));
    }
    for (std::size_t k = 0; k < crossings_.size(); ++k) of(k).crossings.push_back(k);
    const auto isWanted = [&](std::size_t node) { return wants_all || of(node).crossings.empty(); };
    forEachPoint(isWanted, [&](const NodePoint& point) { of(point.node).points.push_back(boundaryPoint(point)); });
    if (!wants_all) return result;
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      if (nodes_[k].is_inner && nodes_[sets_.find(k)].is_counted) of(k).inner = true;
    for (std::size_t k = 0; k < crossings_.size(); ++k)
      if (!of(k).inner) lookBeside(crossings_[k], of(k));
    return result;
  }

  /// Which sides of a common stretch of two edges the regions are on.
  void lookBeside(const EdgeCrossing& crossing, OverlapComponent& component) const {
    const Ends edge = frame_.edgeEndsOfA(crossing.edge_a);
    const Vec2 way = edge.w - edge.v;
    const double length = way.norm() * (crossing.on_a.high - crossing.on_a.low), error = frame_.error();
    if (!(length > 32 * error)) return;
    const Vec2 normal = Vec2(-way.y(), way.x()).normalized(), beside = 8 * error * normal;
    const Vec2 point = frame_.edgeOfA(crossing.edge_a, somewhere(crossing.on_a));
    const bool a_left = holds(0, point + beside), a_right = holds(0, point - beside);
    const bool b_left = holds(1, point + beside), b_right = holds(1, point - beside);
    component.inner = (a_left && b_left) || (a_right && b_right);
    if (a_right && b_left) component.facing += length * normal;
    if (a_left && b_right) component.facing -= length * normal;
  }

  const PosedPair &pair_, swapped_;
  const WorldFrame& frame_;
  const std::vector<EdgeCrossing>& crossings_;
  Side sides_[2];
  struct Node {
    bool is_present;  ///< it is in the overlap, which a polygon's own crossing needn't be
    bool is_inner;    ///< the overlap has an inside there
    bool is_counted;  ///< of a set that is in the overlap, by its own node
    std::size_t component = 0;
  };
  UnionFind sets_;  ///< of nodes
  std::vector<Node> nodes_;
  std::vector<Arc> arcs_;
};

}  // namespace

std::vector<OverlapComponent> findComponents(const PosedPair& pair, const WorldFrame& frame,
                                             const std::vector<EdgeCrossing>& crossings, ContactDetail detail) {
  return Grouping(pair, frame, crossings).components(detail);
}

}  // namespace tricover::detail
