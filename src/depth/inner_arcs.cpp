// SPDX-License-Identifier: BSD-3-Clause
#include "depth/inner_arcs.h"

#include <algorithm>

#include "contact/boundary_point.h"

namespace tricover::detail {
namespace {

/// Where a ring meets an edge of the other polygon.
struct RingStop {
  EdgePosition edge;
  double at;
  EdgePosition other;
  int change;  ///< of the other's winding number; 0 if it may be anything
};

class Collector {
 public:
  Collector(const PosedPair& pair, const WorldFrame& frame, int side, bool wants_inside, bool has_windings,
            InnerArcs& result)
      : pair_(side == 0 ? pair.back() : pair),
        frame_(frame),
        side_(side),
        own_(polygonOf(pair, side)),
        wants_inside_(wants_inside),
        has_windings_(has_windings),
        result_(result) {}

  void addRing(std::size_t ring, const RingStop* begin, const RingStop* end) {
    const EdgePosition first = own_.edgeBegin(ring), last = own_.edgeEnd(ring);
    if (begin == end) return addWhole(first, last);
    Winding winding;  // the other's, in the world
    const RingStop* stop = end - 1;
    for (const RingStop* next = begin; next < end; stop = next++) {
      winding.pass({stop->change != 0, stop->change});
      addArc(*stop, *next, stop < next && stop->edge == next->edge, first, last, winding);
    }
  }

 private:
  void addWhole(EdgePosition first, EdgePosition last) {
    const Winding winding = windingAt(first);
    if (winding.known && !isSought(winding)) return;
    begin();
    for (EdgePosition v = first; v <= last; ++v) add(vertex(v), v);
    end(winding.known, kNoEdge, kNoEdge);
  }

  void addArc(const RingStop& stop, const RingStop& next, bool on_one_edge, EdgePosition first, EdgePosition last,
              Winding& winding) {
    const auto after = [&](EdgePosition v) { return v + 1 < last ? v + 1 : first; };
    if (!on_one_edge && !winding.known) winding = windingAt(after(stop.edge));
    if (winding.known && !isSought(winding)) return;
    begin();
    add(on(stop), stop.edge);
    if (!on_one_edge) {
      EdgePosition v = after(stop.edge);
      add(vertex(v), v);
      for (; v != next.edge; add(vertex(v), v)) v = after(v);
    }
    add(on(next), next.edge);
    end(winding.known, stop.other, next.other);
  }

  Winding windingAt(EdgePosition v) const {
    if (!has_windings_) return {};
    const Inclusion found = includeVertexOfB(pair_, v);
    return {found.location != Location::Boundary, found.winding};
  }
  bool isSought(const Winding& winding) const { return isInside(pair_.a.fill, winding.number) == wants_inside_; }

  Vec2 vertex(EdgePosition v) const { return frame_.from(side_, own_.path[v]); }
  Vec2 on(const RingStop& stop) const {
    const Vec2 v = vertex(stop.edge), w = vertex(stop.edge + 1);
    return stop.at < 0.5 ? Vec2(v + stop.at * (w - v)) : Vec2(w - (1 - stop.at) * (w - v));
  }

  void begin() { from_ = result_.points.size(); }
  void add(const Vec2& point, EdgePosition edge) {
    result_.points.push_back(point);
    result_.edges.push_back(edge);
  }
  void end(bool is_known, EdgePosition met, EdgePosition met_last) {
    result_.arcs.push_back({from_, result_.points.size() - 1, is_known, {met, met_last}});
  }

  const PosedPair pair_;  ///< the other polygon, then this one
  const WorldFrame& frame_;
  const int side_;
  const PolygonData& own_;
  const bool wants_inside_, has_windings_;
  InnerArcs& result_;
  std::size_t from_ = 0;
};

}  // namespace

InnerArcs::InnerArcs(const PosedPair& pair, const WorldFrame& frame, const std::vector<EdgeCrossing>& crossings,
                     int side, bool wants_inside, bool has_windings) {
  std::vector<RingStop> meetings;
  for (const EdgeCrossing& c : crossings) {
    const Span& on = c.on[side];
    const int change = side == 0 ? -c.direction : c.direction;
    if (change != 0) {
      meetings.push_back({c.edge[side], on.middle(), c.edge[1 - side], change});
    } else {
      for (const double at : {on.low, on.high}) meetings.push_back({c.edge[side], at, c.edge[1 - side], 0});
    }
  }
  std::sort(meetings.begin(), meetings.end(), [](const RingStop& p, const RingStop& q) {
    return p.edge != q.edge ? p.edge < q.edge : p.at != q.at ? p.at < q.at : p.other < q.other;
  });
  const PolygonData& own = polygonOf(pair, side);
  Collector collector(pair, frame, side, wants_inside, has_windings, *this);
  const RingStop *begin = meetings.data(), *const all = begin + meetings.size();
  for (std::size_t ring = 0; ring < own.ringCount(); ++ring) {
    const RingStop* end = begin;
    while (end < all && end->edge < own.edgeEnd(ring)) ++end;
    collector.addRing(ring, begin, end);
    begin = end;
  }
}

}  // namespace tricover::detail
