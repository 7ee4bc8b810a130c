// SPDX-License-Identifier: BSD-3-Clause
#include "impact/vertex_impact.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "hierarchy/simd.h"
#include "impact/vertex_ways.h"

namespace tricover::detail {
namespace {

/// As a rule ten are enough.
constexpr int kMostIntervals = 64;
constexpr int kMost = SmallPolygon::kMost;

/// A point b beside the edges of a, which the hierarchy finds.
class PointBesideTree {
 public:
  explicit PointBesideTree(const MovingPair& pair) : a_(*pair.a.polygon), pair_(pair), lever_(pair.b.arm.norm()) {}

  Approach soonest(const SearchInterval& interval, bool) const {
    const VertexView view(interval, true);
    struct Call {
      static bool visit(void* context, std::uint32_t position) {
        Call& c = *static_cast<Call*>(context);
        c.view.approach(c.way, EdgeInUnits(c.self.a_, position), 0, position, c.best);
        c.ray.length = std::min(c.best.share, 1.0) * c.length;
        return true;
      }
      const PointBesideTree& self;
      const VertexView& view;
      VertexWay way;
      double length;
      Ray ray;
      Approach best;
    } call{*this, view, view.wayOf(0, 0, lever_), 0, {}, {}};
    const VertexWay& way = call.way;
    const double dx = way.x[1] - way.x[0], dy = way.y[1] - way.y[0];
    call.length = std::hypot(dx, dy);
    call.ray = {way.x[0], way.y[0], 1, 0, view.reach(way) + 0x1p-50 * call.length, call.length};
    if (call.length > 0) call.ray.dx = dx / call.length, call.ray.dy = dy / call.length;
    if (a_.isDegenerate())
      Call::visit(&call, static_cast<std::uint32_t>(a_.degenerate_edge));
    else
      visitEdgesOnRay(*pair_.a.tree, call.ray, &Call::visit, &call);
    return call.best;
  }

  /// A point is on a degenerate polygon for no time at all: that is found where it is.
  bool touchByEnd(const SearchInterval& interval, const Approach& found) const {
    if (a_.isDegenerate()) return false;
    const VertexView view(interval, true);
    return view.touchByEnd(view.wayOf(0, 0, lever_), EdgeInUnits(a_, found.edge));
  }

  FirstContact touch(double time, const Approach& found) const {
    return FirstContact::touch(time, found.edge, pair_.b.polygon->degenerate_edge);
  }

  double size() const { return pair_.a.reach + pair_.b.base.lpNorm<1>(); }

 private:
  const PolygonData& a_;
  const MovingPair& pair_;
  double lever_;
};

/// One of two polygons of few edges: its vertices and edges from S in its units. Each edge begins at the vertex with
/// its number; a degenerate polygon's second vertex has none.
struct FewVertices {
  FewVertices(const Mover& mover, bool turns) : small(mover.tree->small.get()) {
    const PolygonData& polygon = *mover.polygon;
    if (polygon.isDegenerate()) {
      addVertex(polygon, polygon.degenerate_edge, polygon.degenerate_edge);
      addVertex(polygon, polygon.degenerate_edge + 1, polygon.degenerate_edge);
      edge[edge_count++] = EdgeInUnits(vertex[0], vertex[1]);
    } else {
      for (std::size_t ring = 0; ring < polygon.ringCount(); ++ring) addRing(polygon, ring);
    }
    if (!turns) return;
    for (int i = 0; i < count; ++i) levers[i] = leverOf(mover, vertex[i]);
  }

  VertexWay wayIn(const VertexView& view, std::uint32_t i) const {
    return view.wayOf(vertex[i].x(), vertex[i].y(), levers[i]);
  }

  const SmallPolygon* small;  ///< the edges as floats have them, if these do
  int count = 0, edge_count = 0;
  Vec2 vertex[kMost];
  double levers[kMost] = {};    ///< no less than from the pivot, in the pair's length
  std::size_t position[kMost];  ///< of the vertices' edges, in the path
  EdgeInUnits edge[kMost];

 private:
  void addVertex(const PolygonData& polygon, std::size_t at, std::size_t edge_position) {
    vertex[count] = polygon.inUnits(polygon.path[at]);
    position[count++] = edge_position;
  }
  void addRing(const PolygonData& polygon, std::size_t ring) {
    const int first = count;
    for (std::size_t e = polygon.edgeBegin(ring); e < polygon.edgeEnd(ring); ++e) addVertex(polygon, e, e);
    for (; edge_count < count; ++edge_count)
      edge[edge_count] = EdgeInUnits(vertex[edge_count], vertex[edge_count + 1 < count ? edge_count + 1 : first]);
  }
};

/// The vertices of either polygon beside the edges of the other, all at once. In an interval within one that was asked
/// before, only what may meet in that one may meet.
class FewBesideFew {
 public:
  explicit FewBesideFew(const MovingPair& pair)
      : pair_(pair), a_(pair.a, pair.a.turns || pair.b.turns), b_(pair.b, pair.a.turns || pair.b.turns) {}

  Approach soonest(const SearchInterval& interval, bool is_within) {
    const VertexView of_a(interval, false), of_b(interval, true);
    if (!is_within) {
      count_ = 0;
      collect(of_b, true);
      collect(of_a, false);
    }
    Approach best;
    int kept = 0, vertex = -1;
    bool of_vertex_b = false;
    VertexWay way{};
    for (int i = 0; i < count_; ++i) {
      const VertexAndEdge pair = pairs_[i];
      const VertexView& view = pair.of_b ? of_b : of_a;
      if (pair.vertex != vertex || pair.of_b != of_vertex_b) way = (pair.of_b ? b_ : a_).wayIn(view, pair.vertex);
      vertex = pair.vertex, of_vertex_b = pair.of_b;
      if (view.approach(way, (pair.of_b ? a_ : b_).edge[pair.edge], pair.vertex, pair.edge, best))
        pairs_[kept++] = pair;
    }
    count_ = kept;
    return best;
  }

  bool touchByEnd(const SearchInterval& interval, const Approach& found) const {
    const VertexView view(interval, found.of_b);
    return view.touchByEnd((found.of_b ? b_ : a_).wayIn(view, found.vertex), (found.of_b ? a_ : b_).edge[found.edge]);
  }

  FirstContact touch(double time, const Approach& found) const {
    return FirstContact::touch(time, a_.position[found.of_b ? found.edge : found.vertex],
                               b_.position[found.of_b ? found.vertex : found.edge]);
  }

  double size() const { return std::min(pair_.a.reach, pair_.b.reach); }

 private:
  struct VertexAndEdge {
    std::uint8_t vertex, edge;
    bool of_b;  ///< the vertex
  };

  /// What may meet in the interval.
  void collect(const VertexView& view, bool of_b) {
    const FewVertices &from = of_b ? a_ : b_, &of = of_b ? b_ : a_;
    FewWays ways;
    ways.count = of.count;
    bool fits = from.small != nullptr;  // into floats
    for (int k = 0; k < of.count; ++k) {
      const VertexWay way = of.wayIn(view, static_cast<std::uint32_t>(k));
      const double reach = view.reach(way);
      const Double2 size = absolute(way.x) + absolute(way.y);
      fits = fits && size[0] + size[1] + reach < 0x1p30;
      ways.x[k] = static_cast<float>(way.x[0]);
      ways.y[k] = static_cast<float>(way.y[0]);
      ways.to_x[k] = static_cast<float>(way.x[1]);
      ways.to_y[k] = static_cast<float>(way.y[1]);
      ways.reach[k] = static_cast<float>(reach);
    }
    unsigned near[kMost];
    if (fits)
      findEdgesOnWays(*from.small, ways, near);
    else
      std::fill_n(near, of.count, (1u << from.edge_count) - 1);
    for (int k = 0; k < of.count; ++k)
      for (unsigned left = near[k]; left != 0; left &= left - 1)
        pairs_[count_++] = {static_cast<std::uint8_t>(k), static_cast<std::uint8_t>(__builtin_ctz(left)), of_b};
  }

  const MovingPair& pair_;
  FewVertices a_, b_;
  VertexAndEdge pairs_[2 * kMost * kMost];
  int count_ = 0;
};

/// Ways bend little in the first interval.
double firstLength(const MovingPair& pair, double size) {
  const Rates rates = pair.rates(0, 1);
  const double bend = rates.bend(pair.a.reach, pair.b.reach) + rates.pull;
  return bend > 0 ? std::min(1.0, 0.5 * std::sqrt(size / bend)) : 1;
}

/// From interval to interval: each begins where the one before shows that nothing meets until then. While nothing may
/// meet at all they grow; where something may, the next one lies within, and as long as that should take.
template <class Ways>
FirstContact follow(Ways ways, const MovingPair& pair, double begin, double time_error) {
  double time = begin, length = firstLength(pair, ways.size()), last = begin;
  for (int asked = 0; asked < kMostIntervals; ++asked) {
    const bool is_within = time < last;
    const double end = std::min(time + length, is_within ? last : 1.0);
    last = end;
    const SearchInterval interval(pair, time, end);
    const Approach best = ways.soonest(interval, is_within);
    if (!(best.share <= 1)) {
      if (end == 1) return FirstContact::never();
      time = end;
      length *= 2;
      continue;
    }
    if (best.touches) return ways.touch(time, best);
    const double lower = std::min(time + best.share * interval.length, end);
    if (best.is_exact || (end - lower <= time_error && ways.touchByEnd(interval, best))) return ways.touch(lower, best);
    if (!(lower > time)) break;
    time = lower;
    const double ahead = best.aim - best.share;
    length = (ahead > 0 && ahead < 0.25 ? 2 * ahead : 0.5) * interval.length + 0.5 * time_error;
  }
  return FirstContact::unknown(time);
}

}  // namespace

bool haveFewVertexWays(const MovingPair& pair) {
  const auto areFew = [](const PolygonData& polygon) {
    return polygon.path.size() - polygon.ringCount() <= static_cast<std::size_t>(kMost) && !polygon.isPoint();
  };
  return pair.keepLengths() && (pair.b.polygon->isPoint() || (areFew(*pair.a.polygon) && areFew(*pair.b.polygon)));
}

FirstContact followVertices(const MovingPair& pair, double begin, double time_error) {
  return pair.b.polygon->isPoint() ? follow(PointBesideTree(pair), pair, begin, time_error)
                                   : follow(FewBesideFew(pair), pair, begin, time_error);
}

}  // namespace tricover::detail
