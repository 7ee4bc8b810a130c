// SPDX-License-Identifier: BSD-3-Clause
#include "impact/few_edges_impact.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "hierarchy/simd.h"
#include "impact/window_cutter.h"

namespace tricover::detail {
namespace {

/// As a rule ten are enough.
constexpr int kMostSteps = 64;
constexpr int kMost = FewEdges::kMost;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// One of the two polygons: its vertices and edges from S in its units.
class Outline {
 public:
  Outline(const Mover& mover_, bool turns) : mover(mover_) {
    const PolygonData& polygon = *mover.polygon;
    edges.count = 0;
    if (polygon.isDegenerate()) {
      addVertex(polygon.degenerate_edge, polygon.degenerate_edge);
      addVertex(polygon.degenerate_edge + 1, polygon.degenerate_edge);
      addEdge(0, 1);
    } else {
      for (std::size_t ring = 0; ring < polygon.ringCount(); ++ring) addRing(polygon, ring);
    }
    edges.lanes = edges.count > kLanes ? kMost : kLanes;
    if (!turns) return;
    for (int i = 0; i < count; ++i) {
      const Vec2 lever = mover.arm + mover.scale * (mover.linear * Vec2(x[i], y[i]));
      levers[i] = lengthAbove(lever.x(), lever.y());
    }
  }

  const Mover& mover;
  int count = 0;  ///< of vertices
  double x[kMost], y[kMost];
  double levers[kMost] = {};                   ///< no less than from the pivot, in the pair's length
  std::size_t position[kMost];                 ///< of the vertices' edges, in the path
  double ux[kMost], uy[kMost], length[kMost];  ///< an edge's axis, unless it has no length, and its length
  FewEdges edges{};                            ///< each begins at the vertex with its number

 private:
  void addVertex(std::size_t at, std::size_t edge) {
    const Vec2 p = mover.polygon->inUnits(mover.polygon->path[at]);
    x[count] = p.x();
    y[count] = p.y();
    position[count++] = edge;
  }

  void addRing(const PolygonData& polygon, std::size_t ring) {
    const int first = count;
    for (std::size_t e = polygon.edgeBegin(ring); e < polygon.edgeEnd(ring); ++e) addVertex(e, e);
    for (int i = first; i < count; ++i) addEdge(i, i + 1 < count ? i + 1 : first);
  }

  void addEdge(int i, int next) {
    const double dx = x[next] - x[i], dy = y[next] - y[i], square = dx * dx + dy * dy;
    const bool has_axis = square > 0x1p-900;
    length[i] = std::sqrt(square);
    ux[i] = has_axis ? dx / length[i] : 1;
    uy[i] = has_axis ? dy / length[i] : 0;
    edges.x[i] = static_cast<float>(x[i]);
    edges.y[i] = static_cast<float>(y[i]);
    edges.ux[i] = static_cast<float>(dx);
    edges.uy[i] = static_cast<float>(dy);
    edges.aside[i] = static_cast<float>(dx * y[i] - dy * x[i]);
    edges.ahead[i] = static_cast<float>(dx * x[i] + dy * y[i]);
    edges.square[i] = static_cast<float>(square);
    edges.length[i] = static_cast<float>(length[i] * (1 + 0x1p-20) + 0x1p-60);
    ++edges.count;
  }
};

/// A vertex of one and an edge of the other.
struct VertexAndEdge {
  std::uint8_t vertex, edge;
  bool of_b;  ///< the vertex
};

/// How far the two are apart where a window begins, and the share of it before which they don't meet.
struct Approach {
  double apart = kInfinity, share = kInfinity;
  double aim = 0;  ///< as in Rest
  VertexAndEdge pair{};

  bool operator<(const Approach& other) const {
    return share != other.share ? share < other.share : apart < other.apart;
  }
};

/// The vertices of one polygon over a window, seen from the other, which stands still, in that one's units. There a
/// vertex leaves the straight way between its places at both ends by sag / 4 at most.
///
/// Rounding, beyond what MovingPair::error allows for, in units of U: turning differences f back by M^T 4.3 f; M^T M,
/// which isn't quite the identity, 64 r; M itself once more 10.1 A r + 7 r. So gaps are within twice that error.
class Sight {
 public:
  /// A vertex at both ends of the window, and what WindowCutter calls sag.
  struct Way {
    Double2 x, y;
    double sag;
  };

  Sight(const Window& window, const Outline& from, const Outline& of, bool of_b) : from_(from), of_(of), of_b_(of_b) {
    const MovingPair& pair = window.pair;
    const Places &p = of_b ? window.a : window.b, &q = of_b ? window.b : window.a;
    inverse_ = 1 / from.mover.scale;
    const double scale = of.mover.scale * inverse_;
    const Double2 dx = (q.x - p.x) * inverse_, dy = (q.y - p.y) * inverse_;
    m00_ = (p.m00 * q.m00 + p.m10 * q.m10) * scale;
    m01_ = (p.m00 * q.m01 + p.m10 * q.m11) * scale;
    m10_ = (p.m01 * q.m00 + p.m11 * q.m10) * scale;
    m11_ = (p.m01 * q.m01 + p.m11 * q.m11) * scale;
    tx_ = p.m00 * dx + p.m10 * dy;
    ty_ = p.m01 * dx + p.m11 * dy;
    room_ = (pair.margin + 2 * pair.error) * inverse_;
    touch_ = (pair.margin + 4 * pair.error) * inverse_;
    prepareSags(window);
  }

  Way wayOf(int k) const {
    const Double2 x = m00_ * of_.x[k] + m01_ * of_.y[k] + tx_, y = m10_ * of_.x[k] + m11_ * of_.y[k] + ty_;
    const double lever = of_.levers[k];
    double sag = sag_ + sag_by_lever_ * lever;
    if (sag_by_distance_ > 0) {
      const double from_pivot = lengthAbove(x[0] - pivot_.x(), y[0] - pivot_.y()) * from_.mover.scale;
      sag = std::min(sag, other_sag_ + other_by_lever_ * lever + sag_by_distance_ * from_pivot);
    }
    return {x, y, sag};
  }

  /// Adds what may meet in the window.
  int collect(VertexAndEdge* pairs, int count) const {
    FewWays ways;
    ways.count = of_.count;
    bool fits = true;  // into floats
    for (int k = 0; k < of_.count; ++k) {
      const Way way = wayOf(k);
      const double reach = room_ + 0.25 * way.sag;
      const Double2 size = absolute(way.x) + absolute(way.y);
      fits = size[0] + size[1] + reach < 0x1p30;
      if (!fits) break;
      ways.x[k] = static_cast<float>(way.x[0]);
      ways.y[k] = static_cast<float>(way.y[0]);
      ways.to_x[k] = static_cast<float>(way.x[1]);
      ways.to_y[k] = static_cast<float>(way.y[1]);
      ways.reach[k] = static_cast<float>(reach);
    }
    unsigned near[kMost];
    if (fits)
      findEdgesOnWays(from_.edges, ways, near);
    else
      std::fill_n(near, of_.count, (1u << from_.edges.count) - 1);
    for (int k = 0; k < of_.count; ++k)
      for (unsigned left = near[k]; left != 0; left &= left - 1)
        pairs[count++] = {static_cast<std::uint8_t>(k), static_cast<std::uint8_t>(__builtin_ctz(left)), of_b_};
    return count;
  }

  /// Whether the two may meet in the window. If they may do so before `best` does, they are the best.
  bool approach(const Way& way, const VertexAndEdge& pair, Approach& best) const {
    const int e = pair.edge;
    const double half = 0.5 * from_.length[e];
    const Double2 rx = way.x - from_.x[e], ry = way.y - from_.y[e];
    Double2 n = from_.ux[e] * ry - from_.uy[e] * rx, t = from_.ux[e] * rx + from_.uy[e] * ry - half;
    if (n[0] < 0) n = -n;
    if (t[0] < 0) t = -t;
    const double beyond = t[0] - half;
    CutSide first, last;
    if (first.offer(n[0] - room_, n[1] - room_, way.sag)) return false;
    if (first.offer(beyond - room_, t[1] - half - room_, way.sag)) return false;
    double apart = n[0];
    if (beyond > 0) {
      apart = std::sqrt(n[0] * n[0] + beyond * beyond);
      const double end = (beyond * (t[1] - half) + n[0] * n[1]) / apart;
      if (first.offer(apart - room_, end - room_, way.sag)) return false;
    }
    if (n[1] < 0) n = -n;
    if (t[1] < 0) t = -t;
    if (last.offer(n[1] - room_, n[0] - room_, way.sag)) return false;
    if (last.offer(t[1] - half - room_, t[0] - half - room_, way.sag)) return false;
    const double share = first.share();
    if (share > 1 - last.share()) return false;
    const Approach found{apart, share, first.aim(), pair};
    if (found < best) best = found;
    return true;
  }

  /// Whether the two touch at the window's end, or have passed each other by then.
  bool touchByEnd(const VertexAndEdge& pair) const {
    const Way way = wayOf(pair.vertex);
    const Place place = placeOf(way.x, way.y, pair.edge);
    const double reach = room_ + 0.25 * way.sag;
    const bool passed = place.aside[0] * place.aside[1] < 0 && std::max(place.beyond[0], place.beyond[1]) < -reach;
    return passed || touches(place.aside[1], place.beyond[1]);
  }

  /// Whether they touch after a share of the window, if the way isn't bent.
  bool touchAt(const VertexAndEdge& pair, double share) const {
    const Way way = wayOf(pair.vertex);
    if (way.sag > 0) return false;
    const Place place =
        placeOf(way.x + share * (swapped(way.x) - way.x), way.y + share * (swapped(way.y) - way.y), pair.edge);
    return touches(place.aside[0], place.beyond[0]);
  }

  double touchDistance() const { return touch_; }

 private:
  /// A point's distance from an edge's line, and along it from the nearer end: negative beside the edge.
  struct Place {
    Double2 aside, beyond;
  };
  Place placeOf(Double2 x, Double2 y, int e) const {
    const double half = 0.5 * from_.length[e];
    const Double2 rx = x - from_.x[e], ry = y - from_.y[e];
    return {from_.ux[e] * ry - from_.uy[e] * rx, absolute(from_.ux[e] * rx + from_.uy[e] * ry - half) - half};
  }
  /// Written so that NaN is a touch.
  bool touches(double aside, double beyond) const {
    const double past = std::max(beyond, 0.0);
    return !(std::sqrt(aside * aside + past * past) > touch_);
  }

  /// As WindowCutter has them along an axis that turns with the polygon that is looked from: sums of what all vertices
  /// have, and what is in proportion to their levers and to their distances from that one's pivot.
  void prepareSags(const Window& window) {
    const Rates& rates = window.rates;
    const double h = window.length, half_square = 0.5 * (1 + 0x1p-10) * h * h * inverse_;
    const double turn = of_b_ ? rates.a : rates.b, own = of_b_ ? rates.b : rates.a;
    const double bend = of_b_ ? rates.bend_a : rates.bend_b, mixed = of_b_ ? rates.mixed_b : rates.mixed_a;
    const double always = 2 * turn * rates.speed + rates.pull;
    sag_by_lever_ = half_square * rates.relative_bend;
    sag_ = half_square * always;
    sag_by_distance_ = half_square * bend;
    if (!(bend > 0)) return;
    const Places &p = window.a, &q = window.b;
    const double apart = lengthAbove(q.pivot_x[0] - p.pivot_x[0], q.pivot_y[0] - p.pivot_y[0]);
    sag_ += sag_by_distance_ * (apart + h * rates.speed);
    other_by_lever_ = half_square * (mixed + bend * h * own);
    other_sag_ = half_square * (always + bend * h * rates.speed);
    pivot_ = from_.mover.linear.transpose() * from_.mover.arm * -inverse_;
  }

  const Outline &from_, &of_;
  bool of_b_;
  double inverse_, room_, touch_;  ///< in units: what a gap must exceed, and what is near enough
  Double2 m00_, m01_, m10_, m11_, tx_, ty_;
  double sag_, sag_by_lever_, other_sag_ = 0, other_by_lever_ = 0, sag_by_distance_;
  Vec2 pivot_;
};

/// From window to window: each begins where the one before shows that nothing meets until then. While nothing may meet
/// at all they grow; where something may, the next one lies within, and as long as that should take.
class FewEdgesSearch {
 public:
  FewEdgesSearch(const MovingPair& pair, double time_error)
      : pair_(pair),
        a_(pair.a, pair.a.turns || pair.b.turns),
        b_(pair.b, pair.a.turns || pair.b.turns),
        time_error_(time_error) {}

  FirstContact run() {
    using Verdict = FirstContact::Verdict;
    double time = 0, length = firstLength(), last = 0;
    for (int step = 0; step < kMostSteps; ++step) {
      // In a window within one that was asked before, only what may meet in that one may meet.
      const bool within = time < last;
      const double end = std::min(time + length, within ? last : 1.0);
      last = end;
      const Window window(pair_, time, end);
      const Sight of_b(window, a_, b_, true), of_a(window, b_, a_, false);
      if (!within) count_ = of_a.collect(pairs_, of_b.collect(pairs_, 0));
      const Approach best = soonest(of_a, of_b);
      if (!(best.share <= 1)) {
        if (end == 1) return {Verdict::Never, 1, 0, 0};
        time = end;
        length *= 2;
        continue;
      }
      const Sight& sight = best.pair.of_b ? of_b : of_a;
      // Written so that NaN is a touch.
      if (!(best.apart > sight.touchDistance())) return touch(time, best.pair);
      const double lower = std::min(time + best.share * window.length, end);
      if (end - lower <= time_error_ && sight.touchByEnd(best.pair)) return touch(lower, best.pair);
      if (sight.touchAt(best.pair, best.share)) return touch(lower, best.pair);
      if (!(lower > time)) break;
      time = lower;
      const double ahead = best.aim - best.share;
      length = (ahead > 0 && ahead < 0.25 ? 2 * ahead : 0.5) * window.length + 0.5 * time_error_;
    }
    return {Verdict::Unknown, time, 0, 0};
  }

 private:
  double firstLength() const {
    const Rates rates = pair_.rates(0, 1);
    const double bend = rates.bend_a * pair_.a.reach + rates.bend_b * pair_.b.reach + rates.pull;
    return bend > 0 ? std::min(1.0, 0.5 * std::sqrt(std::min(pair_.a.reach, pair_.b.reach) / bend)) : 1;
  }

  /// Drops the pairs that don't meet in the window.
  Approach soonest(const Sight& of_a, const Sight& of_b) {
    Approach best;
    int kept = 0, vertex = 0;
    bool of_vertex_b = false;
    Sight::Way way{};
    for (int i = 0; i < count_; ++i) {
      const VertexAndEdge pair = pairs_[i];
      const Sight& sight = pair.of_b ? of_b : of_a;
      if (i == 0 || pair.vertex != vertex || pair.of_b != of_vertex_b) way = sight.wayOf(pair.vertex);
      vertex = pair.vertex, of_vertex_b = pair.of_b;
      if (sight.approach(way, pair, best)) pairs_[kept++] = pair;
    }
    count_ = kept;
    return best;
  }

  FirstContact touch(double time, const VertexAndEdge& pair) const {
    const std::size_t edge_a = a_.position[pair.of_b ? pair.edge : pair.vertex];
    const std::size_t edge_b = b_.position[pair.of_b ? pair.vertex : pair.edge];
    return {FirstContact::Verdict::Touch, time, edge_a, edge_b};
  }

  const MovingPair& pair_;
  Outline a_, b_;
  double time_error_;
  VertexAndEdge pairs_[2 * kMost * kMost];
  int count_ = 0;
};

}  // namespace

bool haveFewEdges(const MovingPair& pair) {
  const auto fits = [](const Mover& mover) {
    const PolygonData& polygon = *mover.polygon;
    return polygon.path.size() - polygon.ringCount() <= static_cast<std::size_t>(kMost) && !polygon.isPoint() &&
           polygon.fitsUnit() && mover.scale > 0x1p-200 && mover.keepsLengths();
  };
  return fits(pair.a) && fits(pair.b) && pair.error < 1;
}

FirstContact findImpactOfFewEdges(const MovingPair& pair, double time_error) {
  return FewEdgesSearch(pair, time_error).run();
}

}  // namespace tricover::detail
