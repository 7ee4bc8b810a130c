// SPDX-License-Identifier: BSD-3-Clause
// Where the rings of a polygon cross, run along each other, repeat, or have no area.
#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "numbers/predicates.h"
#include "numbers/shortest.h"
#include "overlay/edge_sides.h"
#include "pair/edge_pairs.h"
#include "polygon/edge_walk.h"
#include "tricover/validity.h"

namespace tricover {
namespace detail {
namespace {

/// A ring at a point where it may meet others: it turns there at a vertex, from which `edge` leads on, or passes
/// through on the edge.
struct Visit {
  bool operator<(const Visit& other) const {
    return std::tie(at, edge, passes) < std::tie(other.at, other.edge, other.passes);
  }
  bool operator==(const Visit& other) const { return at == other.at && edge == other.edge && passes == other.passes; }

  OrderedPoint at;
  EdgePosition edge;
  bool passes;
};

/// Orders points around a centre, counter-clockwise from the positive x axis on. Exact.
struct AroundPoint {
  bool isUpper(const Vec2& p) const { return p.y() > centre.y() || (p.y() == centre.y() && p.x() > centre.x()); }
  bool operator()(const Vec2& p, const Vec2& q) const {
    return isUpper(p) != isUpper(q) ? isUpper(p) : orientation(centre, p, q) > 0;
  }

  Vec2 centre;
};

class Search {
 public:
  Search(const PolygonData& polygon, std::size_t most)
      : polygon_(polygon),
        path_(polygon.path),
        most_(most),
        is_flat_(polygon.ringCount()),
        is_crossed_(polygon.ringCount()) {}

  std::vector<SelfCrossing> found() {
    for (std::size_t ring = 0; ring < polygon_.ringCount() && !isEnough(); ++ring) findFlat(ring);
    if (!isEnough()) findMeetings();
    for (std::size_t begin = 0, end; begin < visits_.size() && !isEnough(); begin = end) {
      for (end = begin + 1; end < visits_.size() && visits_[end].at == visits_[begin].at;) ++end;
      findCrossingAt(begin, end);
    }
    if (!isEnough() && polygon_.ringCount() > 1) findHolesOutside();
    const auto key = [](const SelfCrossing& c) { return std::make_tuple(c.edge_a, c.edge_b, c.kind); };
    std::sort(found_.begin(), found_.end(),
              [&](const SelfCrossing& a, const SelfCrossing& b) { return key(a) < key(b); });
    return std::move(found_);
  }

 private:
  bool isEnough() const { return found_.size() >= most_; }

  void findFlat(std::size_t ring) {
    const EdgePosition begin = polygon_.edgeBegin(ring), end = polygon_.edgeEnd(ring);
    EdgePosition other = begin;
    while (other < end && path_[other] == path_[begin]) ++other;
    is_flat_[ring] = true;
    for (EdgePosition v = other; v < end && is_flat_[ring]; ++v)
      is_flat_[ring] = orientation(path_[begin], path_[other], path_[v]) == 0;
    if (is_flat_[ring]) add(SelfCrossingKind::NoArea, path_[begin], begin, begin);
  }

  /// Shows each pair of edges once, of which neither has length 0.
  void findMeetings() {
    const Pose still = Pose::Identity();
    forEachPair(PosedPair(polygon_, still, polygon_, still), 0, [&](double, EdgePosition e, EdgePosition f) {
      if (e < f && path_[e] != path_[e + 1] && path_[f] != path_[f + 1]) meet(e, f);
      return isEnough() ? -1.0 : 0.0;
    });
    std::sort(visits_.begin(), visits_.end());
    visits_.erase(std::unique(visits_.begin(), visits_.end()), visits_.end());
  }

  void meet(EdgePosition e, EdgePosition f) {
    const Vec2 &p = path_[e], &q = path_[e + 1], &r = path_[f], &s = path_[f + 1];
    const int of_r = orientation(p, q, r), of_s = orientation(p, q, s);
    if (of_r == 0 && of_s == 0) return meetAlong(e, f);
    if (of_r * of_s > 0) return;
    const int of_p = orientation(r, s, p), of_q = orientation(r, s, q);
    if (of_p * of_q > 0) return;
    if (of_r * of_s < 0 && of_p * of_q < 0) {
      const double along = fractionExact({nullptr, &path_[e]}, {nullptr, &path_[f]});
      add(SelfCrossingKind::Crossing, (1 - along) * p + along * q, e, f);
    } else {
      visit(of_p == 0 ? p : of_q == 0 ? q : of_r == 0 ? r : s, e, f);
    }
  }

  /// Of edges on one line.
  void meetAlong(EdgePosition e, EdgePosition f) {
    const auto [low_e, high_e] = std::minmax({ordered(path_[e]), ordered(path_[e + 1])});
    const auto [low_f, high_f] = std::minmax({ordered(path_[f]), ordered(path_[f + 1])});
    const OrderedPoint from = std::max(low_e, low_f), to = std::min(high_e, high_f);
    if (from > to) return;
    if (from == to) return visit(Vec2(from.data()), e, f);
    const std::size_t a = polygon_.ringOf(e), b = polygon_.ringOf(f);
    for (const std::size_t ring : {a, b}) is_crossed_[ring] = true;
    if (a == b ? is_flat_[a] : repeat(a, b)) return;
    add(SelfCrossingKind::Overlap, Vec2(from.data()), e, f);
  }

  void visit(const Vec2& at, EdgePosition e, EdgePosition f) {
    for (const EdgePosition edge : {e, f}) {
      if (at == path_[edge])
        visits_.push_back({ordered(at), edge, false});
      else if (at == path_[edge + 1])
        visits_.push_back({ordered(at), edgeAfter(polygon_, edge), false});
      else
        visits_.push_back({ordered(at), edge, true});
    }
  }

  /// Two rings that run through a point cross there where their four directions alternate. Edges that run along each
  /// other have been found before, and say nothing here.
  void findCrossingAt(std::size_t begin, std::size_t end) {
    struct Direction {
      Vec2 to;
      std::size_t visit;
    };
    const AroundPoint is_before{Vec2(visits_[begin].at.data())};
    std::vector<Direction> all;
    for (std::size_t v = begin; v < end; ++v) {
      const EdgePosition edge = visits_[v].edge;
      all.push_back({path_[edge + 1], v});
      all.push_back({path_[visits_[v].passes ? edge : edgeBefore(polygon_, edge)], v});
    }
    std::sort(all.begin(), all.end(), [&](const Direction& a, const Direction& b) { return is_before(a.to, b.to); });
    std::vector<bool> is_along(end - begin);
    for (std::size_t k = 1; k < all.size(); ++k)
      if (!is_before(all[k - 1].to, all[k].to))
        is_along[all[k - 1].visit - begin] = is_along[all[k].visit - begin] = true;
    std::vector<std::size_t> open;
    for (const Direction& direction : all) {
      const std::size_t v = direction.visit;
      if (is_along[v - begin]) continue;
      const auto first = std::find(open.rbegin(), open.rend(), v);
      if (first == open.rend()) {
        open.push_back(v);
        continue;
      }
      if (first != open.rbegin()) {
        const auto [e, f] = std::minmax({visits_[open.back()].edge, visits_[v].edge});
        add(SelfCrossingKind::CrossingAtVertex, is_before.centre, e, f);
        if (isEnough()) return;
      }
      open.erase(std::next(first).base());
    }
  }

  /// Whether two rings, whose edges run along each other, have the same vertices. Known from the first time on.
  bool repeat(std::size_t a, std::size_t b) {
    const auto [known, is_new] = repeats_.insert({{a, b}, false});
    if (is_new) {
      known->second = areEqual(a, b);
      if (known->second)
        add(SelfCrossingKind::RepeatedRing, path_[polygon_.edgeBegin(a)], polygon_.edgeBegin(a), polygon_.edgeBegin(b));
    }
    return known->second;
  }
  bool areEqual(std::size_t a, std::size_t b) const {
    const EdgePosition begin_a = polygon_.edgeBegin(a), begin_b = polygon_.edgeBegin(b);
    const std::size_t size = polygon_.edgeEnd(a) - begin_a;
    if (polygon_.edgeEnd(b) - begin_b != size) return false;
    for (std::size_t shift = 0; shift < size; ++shift) {
      const auto runs = [&](bool back) {
        for (std::size_t i = 0; i < size; ++i)
          if (path_[begin_a + static_cast<EdgePosition>(i)] !=
              path_[begin_b + static_cast<EdgePosition>((shift + (back ? size - i : i)) % size)])
            return false;
        return true;
      };
      if (runs(false) || runs(true)) return true;
    }
    return false;
  }

  /// Of a ring that doesn't cross: 1 counter-clockwise, -1 clockwise. At the ring's first vertex by x, then y, all of
  /// its edges lead to the right, and the lowest one has the outside below.
  std::pair<int, EdgePosition> directionOf(std::size_t ring) const {
    const EdgePosition begin = polygon_.edgeBegin(ring), end = polygon_.edgeEnd(ring);
    EdgePosition first = begin;
    for (EdgePosition v = begin; v < end; ++v)
      if (ordered(path_[v]) < ordered(path_[first])) first = v;
    EdgePosition lowest = first;
    bool leaves = true;
    for (EdgePosition v = begin; v < end; ++v) {
      if (path_[v] != path_[first]) continue;
      const EdgePosition before = edgeBefore(polygon_, v);
      const auto isLower = [&](const Vec2& p) {
        return orientation(path_[first], path_[leaves ? lowest + 1 : lowest], p) < 0;
      };
      if (isLower(path_[v + 1])) lowest = v, leaves = true;
      if (isLower(path_[before])) lowest = before, leaves = false;
    }
    return {leaves ? 1 : -1, lowest};
  }

  void findHolesOutside() {
    const PosedRegions itself(polygon_);
    int shell_direction = 0;
    EdgePosition shell = 0;
    for (std::size_t ring = 0; ring < polygon_.ringCount() && !isEnough(); ++ring) {
      if (is_flat_[ring] || is_crossed_[ring]) continue;
      const auto [direction, edge] = directionOf(ring);
      const EdgeSides beside(itself, EdgeSides::A, edge);
      const EdgeSides::Sides sides = beside.pieces().front().own;
      if (sides.left == sides.right || sides.left != (direction > 0))
        continue;  // no border, or the region is around it
      if (shell_direction == 0) shell_direction = direction, shell = polygon_.edgeBegin(ring);
      const EdgePosition begin = polygon_.edgeBegin(ring);
      if (direction != shell_direction) add(SelfCrossingKind::HoleOutside, path_[begin], begin, shell);
    }
  }

  void add(SelfCrossingKind kind, const Vec2& point, EdgePosition e, EdgePosition f) {
    const std::size_t a = polygon_.ringOf(e), b = polygon_.ringOf(f);
    if (kind != SelfCrossingKind::HoleOutside)
      for (const std::size_t ring : {a, b}) is_crossed_[ring] = true;
    found_.push_back({kind, point, a, b, polygon_.edgeNumber(e), polygon_.edgeNumber(f), {}});
    found_.back().text = textOf(found_.back());
  }

  std::string textOf(const SelfCrossing& c) const {
    const auto ring = [](std::size_t r) { return "ring " + std::to_string(r); };
    const auto edge = [&](std::size_t r, EdgeIndex of) {
      return "the edge from vertex " + std::to_string(of - polygon_.firstNumber(r)) +
             (c.ring_a == c.ring_b ? "" : " of " + ring(r));
    };
    const std::string at = " at (" + shortest(c.point.x()) + ", " + shortest(c.point.y()) + ")";
    const std::string other = c.ring_a == c.ring_b ? "itself" : ring(c.ring_b);
    const std::string edges = ": " + edge(c.ring_a, c.edge_a) + " and " + edge(c.ring_b, c.edge_b);
    switch (c.kind) {
      case SelfCrossingKind::Crossing:
        return ring(c.ring_a) + " crosses " + other + at + edges + " cross between their ends";
      case SelfCrossingKind::CrossingAtVertex:
        return ring(c.ring_a) + " crosses " + other + at + edges + " meet there at a vertex";
      case SelfCrossingKind::Overlap:
        return ring(c.ring_a) + " runs along " + other + edges + " share more than a point, from" + at.substr(3) +
               " on";
      case SelfCrossingKind::RepeatedRing:
        return ring(c.ring_a) + " and " + ring(c.ring_b) + " have the same vertices, one of them" + at;
      case SelfCrossingKind::NoArea:
        return ring(c.ring_a) + at + " has no area: all of its vertices are on one line, or equal";
      case SelfCrossingKind::HoleOutside:
        return ring(c.ring_a) + at + " runs against " + ring(c.ring_b) +
               ", as a hole does, but it is outside of every shell: the region is inside of it";
    }
    return {};
  }

  const PolygonData& polygon_;
  const Path& path_;
  const std::size_t most_;
  std::vector<bool> is_flat_, is_crossed_;  ///< by ring; crossed: something has been found
  std::map<std::pair<std::size_t, std::size_t>, bool> repeats_;
  std::vector<Visit> visits_;
  std::vector<SelfCrossing> found_;
};

}  // namespace
}  // namespace detail

std::vector<SelfCrossing> selfCrossings(const Polygon& polygon, std::size_t most) {
  return detail::Search(detail::dataOf(polygon), most).found();
}

}  // namespace tricover
