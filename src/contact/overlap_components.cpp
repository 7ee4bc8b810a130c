// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap_components.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "contact/overlap_arcs.h"
#include "numbers/segment.h"
#include "overlay/rings.h"

namespace tricover::detail {
namespace {

class Grouping : OverlapArcs {
 public:
  Grouping(const PosedPair& pair, const WorldFrame& frame, const std::vector<EdgeCrossing>& crossings)
      : OverlapArcs(pair, frame, crossings) {}

  std::vector<OverlapComponent> components(ContactDetail detail) {
    join(false);
    std::size_t count = numberComponents();
    // A polygon's own crossings cost a descent of it, and matter only if there is something left to join, or to the
    // sides of pieces, which change there.
    if ((count > 1 || detail != ContactDetail::Points) && (meetsItself(pair_.a) || meetsItself(pair_.b))) {
      join(true);
      count = numberComponents();
    }
    if (count > 1) joinHoles();
    return collect(detail != ContactDetail::Points);
  }

 private:
  void joinHoles() {
    struct Leftmost {
      bool is_known = false;
      NodePoint point;
      Vec2 at;
    };
    std::vector<Leftmost> leftmost(sets_.size());
    const auto offer = [&](const NodePoint& point) {
      Leftmost& best = leftmost[sets_.find(point.node)];
      const Vec2 at = leftEnd(point);
      if (!best.is_known || at.x() < best.at.x()) best = {true, point, at};
    };
    for (std::size_t k = 0; k < crossings_.size(); ++k) offer({k, NodePoint::kCrossing, k});
    for (const Arc& arc : arcs_) forEachVertex(arc, [&](EdgePosition v) { offer({arc.node, arc.side, v}); });
    for (const Leftmost& best : leftmost) {
      if (!best.is_known) continue;
      const std::ptrdiff_t node = overlapsLeftOf(best.point, best.at) ? leftOf(best.at) : besideOf(best.point, best.at);
      if (node >= 0) sets_.join(best.point.node, static_cast<std::size_t>(node));
    }
  }

  /// Of a common stretch of two edges the end on the left, beyond which they needn't be both.
  Vec2 leftEnd(const NodePoint& point) const {
    if (point.side != NodePoint::kCrossing) return vertex(point.side, static_cast<EdgePosition>(point.at));
    const EdgeCrossing& crossing = crossings_[point.at];
    if (crossing.direction != 0) return crossing.point;
    const Vec2 low = frame_.edgeOfA(crossing.edge[0], crossing.on[0].low),
               high = frame_.edgeOfA(crossing.edge[0], crossing.on[0].high);
    return low.x() < high.x() ? low : high;
  }

  /// Whether what is next to the leftmost point of a boundary, outside of it, is in the overlap.
  bool overlapsLeftOf(const NodePoint& point, const Vec2& at) const {
    // Where edges cross, a corner of the overlap is less than a half turn: here to the right.
    if (point.side == NodePoint::kCrossing) {
      if (crossings_[point.at].direction != 0) return false;
    } else {
      const int side = point.side;
      const BoundaryPoint p = vertexPoint(sides_[side].polygon, side, static_cast<EdgePosition>(point.at), at);
      const EdgePosition edge = p.edge[side], before = p.before[side];
      // Both edges lead to the right: their turn tells whether the ring's left side is around the back of them.
      const Ends to = ends(side, edge), from = ends(side, before);
      const double turn = cross(from.v - from.w, to.w - to.v);
      const int region = regionSide(side, edge);
      if (region != 0 && turn != 0) return region * turn > 0;
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
        forEachEdgeOnRay(pair_, frame_, side, p, Vec2(-1, 0), length, [&](EdgePosition edge) {
          addHit(side, edge, p.y(), right, hit);
          return std::min(length, p.x() - hit.x);
        });
      if (!(p.x() - hit.x > length)) return hit.node;
    }
  }

  /// The node of the other polygon's boundary that is no farther from a vertex than rounding; -1 if there is none.
  std::ptrdiff_t besideOf(const NodePoint& point, const Vec2& p) const {
    if (point.side == NodePoint::kCrossing) return -1;
    const int other = 1 - point.side;
    const double error = 4 * frame_.error();
    std::ptrdiff_t node = -1;
    forEachEdgeOnRay(pair_, frame_, other, p, Vec2(-1, 0), error, [&](EdgePosition edge) {
      const auto [v, w] = ends(other, edge);
      const Vec2 way = w - v;
      const double t = way.isZero(0) ? 0 : std::clamp(way.dot(p - v) / way.squaredNorm(), 0.0, 1.0);
      if (node < 0 && (v + t * way - p).norm() <= error) node = nodeAt(other, edge, t);
      return error;
    });
    return node;
  }

  struct Hit {
    double x;
    std::ptrdiff_t node;
  };

  void addHit(int side, EdgePosition edge, double y, double right, Hit& hit) const {
    const auto [v, w] = ends(side, edge);
    if (y < std::min(v.y(), w.y()) || y > std::max(v.y(), w.y())) return;
    const double t = v.y() != w.y() ? (y - v.y()) / (w.y() - v.y()) : v.x() < w.x() ? 1 : 0;
    const double x = v.x() + t * (w.x() - v.x());
    if (x > right || x < hit.x) return;
    // The ray begins in the overlap, and leaves it by an edge that has one: any other is nearer by rounding alone.
    if (const std::ptrdiff_t node = nodeAt(side, edge, t); node >= 0) hit = {x, node};
  }

  /// A node that the point t of an edge is joined to; -1 if it isn't in the other region.
  std::ptrdiff_t nodeAt(int side, EdgePosition edge, double t) const {
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

  /// For points alone, without the points of components that have crossings.
  std::vector<OverlapComponent> collect(bool wants_all) {
    std::vector<OverlapComponent> components(numberComponents());
    for (std::size_t k = 0; k < crossings_.size(); ++k) {
      OverlapComponent& component = components[nodes_[k].component];
      const EdgeCrossing& c = crossings_[k];
      if (wants_all) component.points.push_back({c.point, {c.edge[0], c.edge[1]}, {c.edge[0], c.edge[1]}});
      component.crossings.push_back(k);
    }
    for (const Arc& arc : arcs_) {
      OverlapComponent& component = components[nodes_[arc.node].component];
      if (wants_all || component.crossings.empty()) addVertices(arc, component.points);
    }
    if (!wants_all) return components;
    lookInside(components);
    for (const int side : {0, 1}) addPieces(side, components);
    addCommonPieces(components);
    return components;
  }

  /// Of one side's edges, from stop to stop.
  void addPieces(int side, std::vector<OverlapComponent>& components) {
    const Side& own = sides_[side];
    for (std::size_t r = 0; r < own.polygon.ringCount(); ++r) {
      const Side::RingStops& ring = own.rings[r];
      const EdgePosition begin = own.polygon.edgeBegin(r), end = own.polygon.edgeEnd(r);
      if (ring.node >= 0)
        for (EdgePosition e = begin; e < end; ++e)
          addPiece(side, e, {0, 1}, nodes_[static_cast<std::size_t>(ring.node)].component, components);
      double reach = 0;  // stops may be within others
      for (std::size_t k = ring.begin; ring.node < 0 && k < ring.end; ++k) {
        const Stop &stop = own.stops[k], &next = own.stops[k + 1 < ring.end ? k + 1 : ring.begin];
        const bool is_same_edge = k > ring.begin && own.stops[k - 1].edge == stop.edge;
        reach = is_same_edge ? std::max(reach, stop.span.high) : stop.span.high;
        if (!stop.joined) continue;
        const std::size_t component = nodes_[stop.node].component;
        if (!own.stops[k > ring.begin ? k - 1 : ring.end - 1].joined)
          addPiece(side, edgeBefore(own.polygon, stop.edge), {0, 0}, component, components);
        if (!next.joined) addPiece(side, edgeAfter(own.polygon, next.edge), {0, 0}, component, components);
        if (stop.edge == next.edge && k + 1 < ring.end) {
          addPiece(side, stop.edge, {reach, next.span.low}, component, components);
          continue;
        }
        addPiece(side, stop.edge, {reach, 1}, component, components);
        const auto after = [&](EdgePosition e) { return e + 1 < end ? e + 1 : begin; };
        for (EdgePosition e = after(stop.edge); e != next.edge; e = after(e))
          addPiece(side, e, {0, 1}, component, components);
        addPiece(side, next.edge, {0, next.span.low}, component, components);
      }
    }
  }

  /// The stretches that edges of both polygons share, with both regions on the same side. A stretch is cut where a
  /// polygon meets itself.
  void addCommonPieces(std::vector<OverlapComponent>& components) {
    std::vector<double> cuts;
    for (std::size_t k = 0; k < crossings_.size(); ++k) {
      const EdgeCrossing& c = crossings_[k];
      const Ends a = ends(0, c.edge[0]), b = ends(1, c.edge[1]);
      const bool alike = (a.w - a.v).dot(b.w - b.v) > 0;
      cuts = {0, 1};
      addCuts(0, c, true, cuts);
      addCuts(1, c, alike, cuts);
      std::sort(cuts.begin(), cuts.end());
      for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
        addCommonPiece(c, alike, cuts[i], cuts[i + 1], components[nodes_[k].component].pieces);
    }
  }

  /// The shares of a stretch that two edges have in common, seen along a's, where one side's edge has stops. `alike`:
  /// whether that edge runs as a's does.
  void addCuts(int side, const EdgeCrossing& c, bool alike, std::vector<double>& cuts) const {
    const double length = c.on[side].high - c.on[side].low;
    if (!(length > 0)) return;
    forEachStop(side, c.edge[side], [&](const Stop& stop) {
      for (const double at : {stop.span.low, stop.span.high}) {
        const double share = (at - c.on[side].low) / length;
        if (0 < share && share < 1) cuts.push_back(alike ? share : 1 - share);
      }
    });
  }

  /// On an edge, in order.
  template <typename Visit>
  void forEachStop(int side, EdgePosition edge, Visit visit) const {
    const auto& stops = sides_[side].stops;
    auto stop = std::partition_point(stops.begin(), stops.end(), [&](const Stop& s) { return s.edge < edge; });
    for (; stop != stops.end() && stop->edge == edge; ++stop) visit(*stop);
  }

  void addCommonPiece(const EdgeCrossing& c, bool alike, double from, double to, std::vector<OutlinePiece>& common) {
    const auto part = [](const Span& on, double begin, double end) {
      return Span{on.low + begin * (on.high - on.low), on.low + end * (on.high - on.low)};
    };
    OutlinePiece pieces[2];
    if (!makePiece(0, c.edge[0], part(c.on[0], from, to), pieces[0])) return;
    if (!makePiece(1, c.edge[1], alike ? part(c.on[1], from, to) : part(c.on[1], 1 - to, 1 - from), pieces[1])) return;
    const auto share = [&](bool left_of_a) {
      return left_of_a ? pieces[0].left && (alike ? pieces[1].left : pieces[1].right)
                       : pieces[0].right && (alike ? pieces[1].right : pieces[1].left);
    };
    if (!share(true) && !share(false)) return;
    for (const OutlinePiece& piece : pieces) addWithEdge(piece, common);
  }

  void addPiece(int side, EdgePosition edge, const Span& on, std::size_t component,
                std::vector<OverlapComponent>& components) {
    if (component == kNone || components[component].crossings.empty()) return;
    OutlinePiece piece;
    if (!makePiece(side, edge, on, piece)) return;
    addWithEdge(piece, on.high > on.low ? components[component].pieces : components[component].around);
  }

  /// A piece, and what is known of the rest of its edge, as pieces without length.
  void addWithEdge(const OutlinePiece& piece, std::vector<OutlinePiece>& pieces) {
    const bool is_first =
        pieces.empty() || pieces.back().side != piece.side || pieces.back().position != piece.position;
    if (is_first && piece.known.high - piece.known.low < 1) {
      for (OutlinePiece part : partsOf(piece.side, piece.position)) {
        if (part.known.low == piece.known.low || (part.left && part.right)) continue;
        part.on = {part.known.low, part.known.low};
        pieces.push_back(part);
      }
    }
    pieces.push_back(piece);
  }

  /// On which side of an edge its region is, in the world: see RegionSides.
  int regionSide(int side, EdgePosition edge) const {
    const PolygonData& polygon = sides_[side].polygon;
    const int region = regionSidesOf(polygon).rings[polygon.ringOf(edge)];
    return isMirrored(poseOf(pair_, side)) ? -region : region;
  }

  /// False if it is no longer than rounding.
  bool makePiece(int side, EdgePosition edge, const Span& on, OutlinePiece& piece) {
    piece = {ends(side, edge), on, {0, 1}, side, edge, false, false};
    const double length = on.high > 0 ? piece.length() : piece.way().norm();
    if (!(on.high >= on.low && length > 4 * frame_.error())) return false;
    if (const int region = regionSide(side, edge); region != 0) {
      piece.left = region > 0;
      piece.right = !piece.left;
      return true;
    }
    for (const OutlinePiece& part : partsOf(side, edge)) {
      if (!(somewhere(on) <= part.known.high)) continue;
      piece = part;
      piece.on = on;
      return true;
    }
    return false;
  }

  /// The parts of an edge whose polygon meets itself, from one such point to the next: the region may change sides
  /// there.
  const std::vector<OutlinePiece>& partsOf(int side, EdgePosition edge) {
    if (!parts_.empty() && parts_.front().side == side && parts_.front().position == edge) return parts_;
    parts_.clear();
    double from = 0;
    const auto addUntil = [&](double to) {
      if (to > from) addPart({ends(side, edge), {from, to}, {from, to}, side, edge, false, false});
      from = std::max(from, to);
    };
    forEachStop(side, edge, [&](const Stop& stop) {
      if (stop.node >= crossings_.size()) addUntil(stop.span.low);
    });
    addUntil(1);
    return parts_;
  }

  /// Whether a region holds what is just to the left of a way at a point, and what is to the right.
  std::pair<bool, bool> heldBeside(int side, const Vec2& point, const Vec2& way) const {
    const Vec2 beside = 8 * frame_.error() * Vec2(-way.y(), way.x()).normalized();
    return {holds(side, point + beside), holds(side, point - beside)};
  }

  void addPart(OutlinePiece part) {
    if (!(part.length() > 4 * frame_.error())) return;
    const auto [left, right] = heldBeside(part.side, part.edge.v + somewhere(part.known) * part.way(), part.way());
    part.left = left, part.right = right;
    parts_.push_back(part);
  }

  /// How many there are; their nodes know theirs.
  std::size_t numberComponents() {
    for (Node& node : nodes_) node.component = kNone;
    std::size_t count = 0;
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      Node& root = nodes_[sets_.find(k)];
      if (nodes_[k].is_present && root.component == kNone) root.component = count++;
    }
    for (std::size_t k = 0; k < nodes_.size(); ++k) nodes_[k].component = nodes_[sets_.find(k)].component;
    return count;
  }

  void addVertices(const Arc& arc, std::vector<BoundaryPoint>& points) const {
    const int side = arc.side;
    EdgePosition before = kNoEdge;
    forEachVertex(arc, [&](EdgePosition v) {
      if (before == kNoEdge) {
        points.push_back(vertexPoint(sides_[side].polygon, side, v, vertex(side, v)));
      } else {
        BoundaryPoint& point = points.emplace_back(BoundaryPoint{vertex(side, v)});
        point.edge[side] = v;
        point.before[side] = before;
      }
      before = v;
    });
  }

  void lookInside(std::vector<OverlapComponent>& components) const {
    for (const Node& node : nodes_)
      if (node.is_inner && node.component != kNone) components[node.component].inner = true;
    for (std::size_t k = 0; k < crossings_.size(); ++k) {
      OverlapComponent& component = components[nodes_[k].component];
      if (!component.inner) lookBeside(crossings_[k], component);
    }
  }

  /// Which sides of a common stretch of two edges the regions are on.
  void lookBeside(const EdgeCrossing& crossing, OverlapComponent& component) const {
    const Ends edge = frame_.edgeEndsOfA(crossing.edge[0]);
    const Vec2 way = edge.w - edge.v;
    const double length = way.norm() * (crossing.on[0].high - crossing.on[0].low);
    if (!(length > 32 * frame_.error())) return;
    const Vec2 normal = Vec2(-way.y(), way.x()).normalized();
    const Vec2 point = frame_.edgeOfA(crossing.edge[0], somewhere(crossing.on[0]));
    const auto [a_left, a_right] = heldBeside(0, point, way);
    const auto [b_left, b_right] = heldBeside(1, point, way);
    component.inner = (a_left && b_left) || (a_right && b_right);
    if (a_right && b_left) component.facing += length * normal;
    if (a_left && b_right) component.facing -= length * normal;
  }

  std::vector<OutlinePiece> parts_;  ///< of the edge that was asked for last
};

}  // namespace

std::vector<OverlapComponent> findComponents(const PosedPair& pair, const WorldFrame& frame,
                                             const std::vector<EdgeCrossing>& crossings, ContactDetail detail) {
  return Grouping(pair, frame, crossings).components(detail);
}

}  // namespace tricover::detail
