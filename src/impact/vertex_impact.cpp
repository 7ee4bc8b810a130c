// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "hierarchy/simd.h"
#include "impact/impact_solvers.h"
#include "impact/vertex_paths.h"
#include "numbers/march.h"

namespace tricover::detail {
namespace {

/// As a rule ten are enough.
constexpr int kMostIntervals = 64;
constexpr int kMost = SmallPolygon::kMost;

/// A point b beside the edges of a, which the hierarchy finds.
class PointBesideTree {
 public:
  explicit PointBesideTree(const MovingPair& pair) : a_(*pair.a.polygon), pair_(pair), lever_(pair.b.arm.norm()) {}

  Approach soonest(const TimeInterval& interval, bool) const {
    const VertexView view(interval, true);
    const VertexPath path = view.pathOf(Vec2::Zero(), lever_);
    const double dx = path.x[1] - path.x[0], dy = path.y[1] - path.y[0], length = std::hypot(dx, dy);
    Ray ray{path.x[0], path.y[0], 1, 0, view.reachOfRing(path) + 0x1p-50 * length, length};
    if (length > 0) ray.dx = dx / length, ray.dy = dy / length;
    Approach best;
    auto visit = [&](EdgePosition position) {
      view.approach(path, EdgeInUnits(pair_.a, position), 0, position, best);
      ray.length = std::min(best.share, 1.0) * length;
      return true;
    };
    if (a_.isDegenerate())
      visit(a_.degenerate_edge);
    else
      visitEdgesOnRay(
          *pair_.a.tree, ray,
          [](void* call, EdgePosition edge) { return (*static_cast<decltype(visit)*>(call))(edge); }, &visit);
    return best;
  }

  /// A point is on a degenerate polygon for no time at all: that is found where it is.
  bool touchByEnd(const TimeInterval& interval, const Approach& found) const {
    if (a_.isDegenerate()) return false;
    const VertexView view(interval, true);
    return view.touchByEnd(view.pathOf(Vec2::Zero(), lever_), EdgeInUnits(pair_.a, found.edge));
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

/// One of two polygons of at most 16 edges: its vertices and edges from S in its units. Each edge begins at the vertex
/// with its number; a degenerate polygon's second vertex has none.
struct SmallVertices {
  SmallVertices(const Mover& mover, bool rotates) : small(mover.tree->small.get()) {
    const PolygonData& polygon = *mover.polygon;
    if (polygon.isDegenerate()) {
      addVertex(mover, polygon.degenerate_edge, polygon.degenerate_edge);
      addVertex(mover, polygon.degenerate_edge + 1, polygon.degenerate_edge);
      edge[edge_count++] = EdgeInUnits(vertex[0], vertex[1]);
    } else {
      for (std::size_t ring = 0; ring < polygon.ringCount(); ++ring) addRing(mover, ring);
    }
    if (!rotates) return;
    for (int i = 0; i < count; ++i) levers[i] = leverOf(mover, vertex[i]);
  }

  VertexPath pathIn(const VertexView& view, std::uint32_t i) const { return view.pathOf(vertex[i], levers[i]); }

  const SmallPolygon* small;  ///< the edges as floats have them, if these do
  int count = 0, edge_count = 0;
  Vec2 vertex[kMost];
  double levers[kMost] = {};     ///< no less than from the pivot, in the pair's length
  EdgePosition position[kMost];  ///< of the vertices' edges, in the path
  EdgeInUnits edge[kMost];

 private:
  void addVertex(const Mover& mover, EdgePosition at, EdgePosition edge_position) {
    vertex[count] = mover.inView(at);
    position[count++] = edge_position;
  }
  void addRing(const Mover& mover, std::size_t ring) {
    const int first = count;
    for (EdgePosition e = mover.polygon->edgeBegin(ring); e < mover.polygon->edgeEnd(ring); ++e) addVertex(mover, e, e);
    for (; edge_count < count; ++edge_count)
      edge[edge_count] = EdgeInUnits(vertex[edge_count], vertex[edge_count + 1 < count ? edge_count + 1 : first]);
  }
};

/// The vertices of either polygon beside the edges of the other, all at once. In an interval within the
/// last one, only what may meet in that one may meet.
class SmallBesideSmall {
 public:
  explicit SmallBesideSmall(const MovingPair& pair)
      : pair_(pair), a_(pair.a, pair.a.rotates || pair.b.rotates), b_(pair.b, pair.a.rotates || pair.b.rotates) {}

  Approach soonest(const TimeInterval& interval, bool is_within) {
    const VertexView of_a(interval, false), of_b(interval, true);
    if (!is_within) {
      count_ = 0;
      collect(of_b, true);
      collect(of_a, false);
    }
    Approach best;
    int kept = 0, vertex = -1;
    bool of_vertex_b = false;
    VertexPath path{};
    for (int i = 0; i < count_; ++i) {
      const VertexAndEdge pair = pairs_[i];
      const VertexView& view = pair.of_b ? of_b : of_a;
      if (pair.vertex != vertex || pair.of_b != of_vertex_b) path = (pair.of_b ? b_ : a_).pathIn(view, pair.vertex);
      vertex = pair.vertex, of_vertex_b = pair.of_b;
      if (view.approach(path, (pair.of_b ? a_ : b_).edge[pair.edge], pair.vertex, pair.edge, best))
        pairs_[kept++] = pair;
    }
    count_ = kept;
    return best;
  }

  bool touchByEnd(const TimeInterval& interval, const Approach& found) const {
    const VertexView view(interval, found.of_b);
    return view.touchByEnd((found.of_b ? b_ : a_).pathIn(view, found.vertex), (found.of_b ? a_ : b_).edge[found.edge]);
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
    const SmallVertices &from = of_b ? a_ : b_, &of = of_b ? b_ : a_;
    StraightPaths paths;
    paths.count = of.count;
    bool fits = from.small != nullptr;  // into floats
    for (int k = 0; k < of.count; ++k) {
      const VertexPath path = of.pathIn(view, static_cast<std::uint32_t>(k));
      const double reach = view.reachOfRing(path);
      const Double2 size = absolute(path.x) + absolute(path.y);
      fits = fits && size[0] + size[1] + reach < 0x1p30;
      paths.x[k] = static_cast<float>(path.x[0]);
      paths.y[k] = static_cast<float>(path.y[0]);
      paths.to_x[k] = static_cast<float>(path.x[1]);
      paths.to_y[k] = static_cast<float>(path.y[1]);
      paths.reach[k] = static_cast<float>(reach);
    }
    unsigned near[kMost];
    if (fits)
      findEdgesOnPaths(*from.small, paths, near);
    else
      std::fill_n(near, of.count, (1u << from.edge_count) - 1);
    for (int k = 0; k < of.count; ++k)
      for (unsigned left = near[k]; left != 0; left &= left - 1)
        pairs_[count_++] = {static_cast<std::uint8_t>(k), static_cast<std::uint8_t>(__builtin_ctz(left)), of_b};
  }

  const MovingPair& pair_;
  SmallVertices a_, b_;
  VertexAndEdge pairs_[2 * kMost * kMost];
  int count_ = 0;
};

/// Paths bend little in the first interval.
double firstLength(const MovingPair& pair, double size) {
  const Rates rates = pair.rates(0, 1);
  const double bend = rates.bend(pair.a.reach, pair.b.reach) + rates.pull;
  return bend > 0 ? std::min(1.0, 0.5 * std::sqrt(size / bend)) : 1;
}

/// Each interval begins where the one before shows that nothing meets until then. While nothing may meet at all they
/// grow; where something may, the next one lies within, and as long as that should take.
template <class Follower>
FirstContact follow(Follower paths, const MovingPair& pair, double begin, double time_error) {
  double length = firstLength(pair, paths.size()), last = begin;
  return march(FirstContact::unknown(begin), kMostIntervals, [&](double time) -> std::optional<FirstContact> {
    const bool is_within = time < last;
    last = std::min(time + length, is_within ? last : 1.0);
    const TimeInterval interval(pair, time, last);
    const Approach best = paths.soonest(interval, is_within);
    if (!(best.share <= 1)) {
      length *= 2;
      return last == 1 ? FirstContact::never() : FirstContact::unknown(last);
    }
    if (best.touches) return paths.touch(time, best);
    const double lower = std::min(time + best.share * interval.length, last);
    if (best.is_exact || (last - lower <= time_error && paths.touchByEnd(interval, best)))
      return paths.touch(lower, best);
    if (!(lower > time)) return std::nullopt;
    const double ahead = best.aim - best.share;
    length = (ahead > 0 && ahead < 0.25 ? 2 * ahead : 0.5) * interval.length + 0.5 * time_error;
    return FirstContact::unknown(lower);
  });
}

}  // namespace

bool haveFewVertices(const MovingPair& pair) {
  const auto areFew = [](const PolygonData& polygon) {
    return polygon.path.size() - polygon.ringCount() <= static_cast<std::size_t>(kMost) && !polygon.isPoint();
  };
  // A ray beside a speck's tree would be too far away for floats.
  const bool is_in_view = pair.a.in_view == 1 || pair.a.polygon->isDegenerate();
  return pair.isInRange() &&
         (pair.b.polygon->isPoint() ? is_in_view : (areFew(*pair.a.polygon) && areFew(*pair.b.polygon)));
}

FirstContact followVertices(const MovingPair& pair, double begin, double time_error) {
  return pair.b.polygon->isPoint() ? follow(PointBesideTree(pair), pair, begin, time_error)
                                   : follow(SmallBesideSmall(pair), pair, begin, time_error);
}

}  // namespace tricover::detail
