// SPDX-License-Identifier: BSD-3-Clause
#include "pair/collide_by_edges.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "hierarchy/axis_boxes.h"
#include "numbers/double2.h"
#include "pair/containment.h"

namespace tricover::detail {
namespace {

/// What hierarchies would have saved a query that looks at all edges, in these: most where edges are few, which are
/// asked at once then.
std::size_t savedBy(const PolygonData& polygon) {
  const std::size_t edges = polygon.path.size();
  return edges <= SmallPolygon::kMost + 1 ? edges * 3 / 2 : edges * 2 / 3;
}

/// What the hierarchies cost that aren't there, and the edges that are looked at without them: those of both polygons
/// and, of a ring that may be inside, those of the other one.
bool arePaidFor(const PolygonData& a, const PolygonData& b) {
  std::size_t left = 0;
  for (const PolygonData* polygon : {&a, &b})
    if (topIfBuilt(*polygon) == nullptr) left += polygon->hierarchy_rent.left(hierarchyPrice(*polygon));
  const std::size_t cost = a.path.size() * b.ringCount() + b.path.size() * a.ringCount();
  if (left <= cost) return true;
  a.hierarchy_rent.pay(savedBy(a));
  b.hierarchy_rent.pay(savedBy(b));
  return false;
}

/// Edges [begin, end) of one ring, at most kMost; boxes are along the axes of a's frame.
struct Chain {
  static constexpr std::size_t kMost = 8;

  std::uint32_t begin, end;
  Bounds box;
};

/// a's vertices, and b's as a sees them.
struct PointsOfA {
  const PosedPair& pair;
  Double2 operator()(std::size_t i) const { return load2(pair.a.path[i].data()); }
};
struct PointsOfB {
  const PosedPair& pair;
  Double2 operator()(std::size_t i) const {
    const ApproxPoint p = pair.fromB(pair.b.path[i]);
    return Double2{p.x, p.y};
  }
};

/// A polygon's chains, few of which are kept where they are few.
class Chains {
 public:
  template <typename Points>
  Chains(const PolygonData& polygon, Points point, double grown) {
    std::size_t count = polygon.ringCount() + polygon.path.size() / Chain::kMost;
    if (count > kFew) many_.resize(count);
    Chain* chain = begin_ = count > kFew ? many_.data() : few_;
    for (std::size_t ring = 0; ring < polygon.ringCount(); ++ring) {
      const std::size_t end = polygon.edgeEnd(ring);
      Double2 p = point(polygon.edgeBegin(ring));
      for (std::size_t e = polygon.edgeBegin(ring); e < end; ++chain) {
        const std::size_t last = std::min(e + Chain::kMost, end);
        const auto begin = static_cast<std::uint32_t>(e);
        Double2 low = p, high = p;
        while (e < last) {
          p = point(++e);
          low = smaller(low, p);
          high = larger(high, p);
        }
        *chain = {begin, static_cast<std::uint32_t>(last), Bounds::between(low - grown, high + grown)};
        box_ = chain == begin_ ? chain->box : unite(box_, chain->box);
      }
    }
    end_ = chain;
  }

  const Chain* begin() const { return begin_; }
  const Chain* end() const { return end_; }
  std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }
  const Bounds& box() const { return box_; }

  /// Leaves those that meet a box, as all of them together do.
  void keepMeeting(const Bounds& box) {
    if (size() == 1) return;
    Chain* kept = begin_;
    for (const Chain* chain = begin_; chain != end_; ++chain)
      if (chain->box.meets(box)) *kept++ = *chain;
    end_ = kept;
  }

 private:
  static constexpr std::size_t kFew = 40;

  Chain few_[kFew], *begin_, *end_;
  std::vector<Chain> many_;
  Bounds box_;
};

/// A chain's vertices side by side, the last one once more behind them: two are asked at once.
struct ChainPoints {
  template <typename Points>
  ChainPoints(const Chain& chain, Points point) : edges(chain.end - chain.begin) {
    for (std::size_t k = 0; k <= edges; k += 2) {
      const Double2 p = point(chain.begin + k), q = point(chain.begin + std::min(k + 1, edges));
      store2(x + k, Double2{p[0], q[0]});
      store2(y + k, Double2{p[1], q[1]});
    }
  }

  /// The edges that aren't beyond one side of a box, or all of few; a bit each.
  unsigned edgesNear(const Bounds& box) const {
    constexpr std::size_t kFew = 4;  // their lines cost no more than looking
    const unsigned all = (1u << edges) - 1;
    if (edges <= kFew) return all;
    unsigned left = 0, right = 0, below = 0, above = 0;
    for (std::size_t k = 0; k <= edges; k += 2) {
      const Double2 px = load2(x + k), py = load2(y + k);
      left |= bitsOf(px < box.min_x) << k;
      right |= bitsOf(px > box.max_x) << k;
      below |= bitsOf(py < box.min_y) << k;
      above |= bitsOf(py > box.max_y) << k;
    }
    const unsigned beyond = (left & left >> 1) | (right & right >> 1) | (below & below >> 1) | (above & above >> 1);
    return all & ~beyond;
  }

  std::size_t edges;
  double x[Chain::kMost + 2], y[Chain::kMost + 2];
};

/// The line of an edge: how far points are to its left, times its length.
struct EdgeLine {
  EdgeLine(const ChainPoints& chain, std::size_t k)
      : x(chain.x[k]), y(chain.y[k]), along_x(chain.x[k + 1] - x), along_y(chain.y[k + 1] - y) {}
  template <typename Number>
  Number leftOf(Number px, Number py) const {
    return along_x * (py - y) - along_y * (px - x);
  }
  double length() const { return std::abs(along_x) + std::abs(along_y); }  ///< or more

  double x, y, along_x, along_y;
};

/// Which vertices are on either side of a line by more than `bound`; a bit each.
struct Sides {
  Sides(const EdgeLine& line, double bound, const ChainPoints& points) {
    for (std::size_t k = 0; k <= points.edges; k += 2) {
      const Double2 area = line.leftOf(load2(points.x + k), load2(points.y + k));
      left |= bitsOf(area > bound) << k;
      right |= bitsOf(area < -bound) << k;
    }
  }
  /// Of edges, by their first vertices: whether both ends are on one side.
  unsigned beside() const { return (left & left >> 1) | (right & right >> 1); }
  /// Whether they are on different ones.
  unsigned across() const { return (left & right >> 1) | (right & left >> 1); }

  unsigned left = 0, right = 0;
};

/// Two edges are out of each other's reach if both ends of one are beyond the reach to the same side of the other's
/// line, and cross if both have the ends of the other on different sides. What that leaves open is tested.
///
/// Bound. Of areas that edges and vertices of both chains span, in which no difference of coordinates is more than
/// `size`, the sum of both extents of the box around them, what approxArea() has at most: a's vertices are exact, b's
/// known to `error`, so that e_u <= 2 error, e_w <= error. A reach adds itself times the edge's length, which is off
/// by 4 error.
bool findMeetingEdges(const EdgeTest& test, const Chain& chain_a, const Chain& chain_b, double grown,
                      Outcome& outcome) {
  const PosedPair& pair = test.pair();
  const ChainPoints of_b(chain_b, PointsOfB{pair});
  const unsigned near_b = of_b.edgesNear(chain_a.box.grown(grown));
  if (near_b == 0) return false;
  const ChainPoints of_a(chain_a, PointsOfA{pair});
  const Bounds around = unite(chain_a.box, chain_b.box);
  const Double2 extents = around.high() - around.low();
  const double size = extents[0] + extents[1], reach = pair.reach(test.options.margin);
  const double rounding =
      (1 + 0x1p-10) * (kAreaError * size * size + pair.error * (3 * size + 4 * pair.error + 4 * reach)) + kTiny;
  const double reach_up = (1 + 0x1p-10) * reach;
  for (unsigned near_a = of_a.edgesNear(chain_b.box); near_a != 0; near_a &= near_a - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctz(near_a));
    const EdgeLine line_a(of_a, i);
    const Sides of_line(line_a, rounding + reach_up * line_a.length(), of_b);
    const unsigned across = of_line.across();
    for (unsigned near = near_b & ~of_line.beside(); near != 0; near &= near - 1) {
      const auto j = static_cast<std::size_t>(__builtin_ctz(near));
      const EdgeLine line_b(of_b, j);
      const double bound = rounding + reach_up * line_b.length();
      const double v = line_b.leftOf(of_a.x[i], of_a.y[i]), w = line_b.leftOf(of_a.x[i + 1], of_a.y[i + 1]);
      if ((v > bound && w > bound) || (v < -bound && w < -bound)) continue;
      const bool cross = (across >> j & 1) != 0 && std::abs(v) > bound && std::abs(w) > bound;
      if (!cross && !test(chain_a.begin + i, chain_b.begin + j)) continue;
      outcome.collides = true;
      outcome.edge_a = static_cast<std::ptrdiff_t>(chain_a.begin + i);
      outcome.edge_b = static_cast<std::ptrdiff_t>(chain_b.begin + j);
      return true;
    }
  }
  return false;
}

}  // namespace

std::optional<Outcome> collideByEdges(const EdgeTest& test) {
  if (arePaidFor(test.a, test.b)) return std::nullopt;
  const PosedPair& pair = test.pair();
  // More than b's points are off in either coordinate, and than growing a box rounds: that is at most an ulp of what
  // they are from a's origin, a sixteenth of the error, and one of the margin.
  const double grown = (2 * pair.error + pair.reach(test.options.margin)) * (1 + 4 * kUnitRoundoff);
  if (!(grown < 0x1p900 && test.a.extent < 0x1p900)) return std::nullopt;
  Outcome outcome;
  Chains of_a(test.a, PointsOfA{pair}, 0), of_b(test.b, PointsOfB{pair}, grown);
  const Bounds box_a = of_a.box(), box_b = of_b.box();
  if (!box_a.meets(box_b)) return outcome;
  of_a.keepMeeting(box_b);
  of_b.keepMeeting(box_a);
  // So many pairs of boxes take half of what hierarchies cost: such a query pays for them alone.
  constexpr std::size_t kMostAnEdge = 32;
  if (of_a.size() * of_b.size() > kMostAnEdge * (test.a.path.size() + test.b.path.size())) return std::nullopt;
  for (const Chain& chain_a : of_a)
    for (const Chain& chain_b : of_b)
      if (chain_a.box.meets(chain_b.box) && findMeetingEdges(test, chain_a, chain_b, grown, outcome)) return outcome;
  // What is inside of a region is inside of the box around it.
  return box_b.contains(box_a) || box_a.grown(2 * grown).contains(box_b) || test.a.ringCount() + test.b.ringCount() > 2
             ? findContainment(pair)
             : outcome;
}

}  // namespace tricover::detail
