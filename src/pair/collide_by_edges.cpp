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

/// What hierarchies would have saved a query that looks at all edges, in these. Few edges are asked at once then: the
/// more there are, the more that saves each.
std::size_t savedBy(const PolygonData& polygon) {
  const std::size_t edges = polygon.path.size();
  return edges <= SmallPolygon::kMost + 1 ? edges * edges / 10 : edges * 2 / 3;
}

/// What the hierarchies cost that aren't there, and the edges that are looked at without them: those of both polygons
/// and, of a ring that may be inside, those of the other one.
bool arePaidFor(const PolygonData& a, const PolygonData& b) {
  const auto leftOf = [](const PolygonData& polygon) {
    return topIfBuilt(polygon) != nullptr ? 0 : polygon.hierarchy_rental.left(hierarchyPrice(polygon));
  };
  const std::size_t cost = a.path.size() * b.ringCount() + b.path.size() * a.ringCount();
  if (leftOf(a) + leftOf(b) <= cost) return true;
  a.hierarchy_rental.add(savedBy(a));
  b.hierarchy_rental.add(savedBy(b));
  return false;
}

/// Edges [begin, end) of one ring, at most kMost; boxes are along the axes of a's frame.
struct Chain {
  static constexpr std::size_t kMost = 8;

  std::uint32_t begin, end;
  Bounds box;
};

/// Which vertices of a chain are on either side of something; a bit each.
struct SideBits {
  void add(Bits2 is_left, Bits2 is_right, std::size_t k) {
    bits |= bitsOf(is_left) << k;
    bits |= bitsOf(is_right) << k << kRight;
  }

  /// Of edges, by their first vertices: whether both ends are on one side.
  unsigned beside() const { return either(bits & bits >> 1); }
  /// Whether they are on different ones.
  unsigned across() const { return either(bits & (bits << kRight | bits >> kRight) >> 1); }

 private:
  static constexpr unsigned kRight = 16;
  static_assert(Chain::kMost + 2 < kRight);

  static unsigned either(unsigned both) { return both | both >> kRight; }

  unsigned bits = 0;
};

/// The lines of so few edges cost no more than looking which of them are beyond one side of a box.
constexpr std::size_t kFewEdges = 4;

/// Two polygons in the world.
struct PointsOf {
  PointsOf(const PosedPair& pair_, const CollideOptions& options)
      : pair(pair_),
        reach(options.margin),
        error(pair.pointError()),
        grown((2 * error + reach) * (1 + 4 * kUnitRoundoff)) {}

  Double2 ofA(std::size_t i) const { return pair.atA(pair.a.path[i]); }
  Double2 ofB(std::size_t j) const { return pair.atB(pair.b.path[j]); }

  const PosedPair& pair;
  double reach, error;
  /// More than two points are off in either coordinate, and than growing a box rounds: that is at most an ulp of the
  /// pair's size, a fifth of the error, and one of the margin.
  double grown;
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

/// A chain's vertices of b, as a sees them, side by side: two are asked at once, for which the last one may stand once
/// more behind them.
struct ChainPoints {
  ChainPoints(std::size_t begin_, std::size_t end, const PointsOf& points) : begin(begin_), edges(end - begin) {
    for (std::size_t k = 0; k <= edges; k += 2) {
      const Double2 p = points.ofB(begin + k), q = points.ofB(begin + std::min(k + 1, edges));
      store2(x + k, Double2{p[0], q[0]});
      store2(y + k, Double2{p[1], q[1]});
    }
  }

  /// The edges that aren't beyond one side of a box, or all of few; a bit each.
  unsigned edgesNear(const Bounds& box) const {
    const unsigned all = (1u << edges) - 1;
    if (edges <= kFewEdges) return all;
    SideBits of_x, of_y;
    for (std::size_t k = 0; k <= edges; k += 2) {
      const Double2 px = load2(x + k), py = load2(y + k);
      of_x.add(box.min_x > px, px > box.max_x, k);
      of_y.add(box.min_y > py, py > box.max_y, k);
    }
    return all & ~(of_x.beside() | of_y.beside());
  }

  std::size_t begin, edges;
  double x[Chain::kMost + 2], y[Chain::kMost + 2];
};

/// The line of an edge: how far points are to its left, times its length.
struct EdgeLine {
  EdgeLine(Double2 from, Double2 to) : x(from[0]), y(from[1]), along_x(to[0] - x), along_y(to[1] - y) {}
  EdgeLine(const ChainPoints& chain, std::size_t k)
      : x(chain.x[k]), y(chain.y[k]), along_x(chain.x[k + 1] - x), along_y(chain.y[k + 1] - y) {}

  /// Two vertices' sides, if they are more than `bound` from the line.
  void addSides(Double2 px, Double2 py, double bound, std::size_t k, SideBits& to) const {
    const Double2 area = along_x * (py - y) - along_y * (px - x);
    to.add(area > bound, area < -bound, k);
  }
  double length() const { return std::abs(along_x) + std::abs(along_y); }  ///< or more

  double x, y, along_x, along_y;
};

/// The sides of a box that a point is beyond; a bit each.
unsigned sidesBeyond(const Bounds& box, Double2 p) { return bitsOf(p < box.low()) | bitsOf(p > box.high()) << 2; }

/// Two edges are out of each other's reach if both ends of one are beyond the reach to the same side of the other's
/// line, and cross if both have the ends of the other on different sides. What that leaves open is tested. a's edges
/// are [begin_a, end_a); those beyond one side of b's box are left out, if they are many.
///
/// Bound. Of areas that edges and vertices of both chains span, in which no difference of coordinates is more than
/// `size`, the sum of both extents of the box around them, what approxArea() has at most: all vertices are known to
/// `error`, so that e_u and e_w are at most 2 error. A reach adds itself times the edge's length, which is off
/// by 4 error.
bool findMeetingEdges(const EdgeTest& test, const Chain& chain_a, const ChainPoints& of_b, const Bounds& box_b,
                      unsigned near_b, const PointsOf& points, Outcome& outcome) {
  const std::size_t begin_a = chain_a.begin, end_a = chain_a.end;
  const Bounds& box_a = chain_a.box;
  const Bounds around = unite(box_a, box_b);
  const Double2 extents = around.high() - around.low();
  const double size = extents[0] + extents[1], error = points.error, reach = points.reach;
  const double rounding =
      (1 + 0x1p-10) * (kAreaError * size * size + error * (4 * size + 8 * error + 4 * reach)) + kTiny;
  const double reach_up = (1 + 0x1p-10) * reach;
  const bool are_few = end_a - begin_a <= kFewEdges;
  Double2 to = points.ofA(begin_a);
  unsigned beyond = are_few ? 0 : sidesBeyond(box_b, to);
  for (std::size_t i = begin_a; i < end_a; ++i) {
    const Double2 from = to;
    to = points.ofA(i + 1);
    if (!are_few) {
      const unsigned from_beyond = beyond;
      beyond = sidesBeyond(box_b, to);
      if ((from_beyond & beyond) != 0) continue;
    }
    const EdgeLine line_a(from, to);
    const double bound_a = rounding + reach_up * line_a.length();
    SideBits of_b_vertices;
    for (std::size_t k = 0; k <= of_b.edges; k += 2)
      line_a.addSides(load2(of_b.x + k), load2(of_b.y + k), bound_a, k, of_b_vertices);
    const Double2 ends_x{from[0], to[0]}, ends_y{from[1], to[1]};
    for (unsigned near = near_b & ~of_b_vertices.beside(); near != 0; near &= near - 1) {
      const auto j = static_cast<std::size_t>(__builtin_ctz(near));
      const EdgeLine line_b(of_b, j);
      SideBits of_ends;
      line_b.addSides(ends_x, ends_y, rounding + reach_up * line_b.length(), 0, of_ends);
      if ((of_ends.beside() & 1) != 0) continue;
      const bool cross = (of_b_vertices.across() >> j & of_ends.across() & 1) != 0;
      if (!cross && !test(i, of_b.begin + j)) continue;
      outcome.collides = true;
      outcome.edge_a = static_cast<std::ptrdiff_t>(i);
      outcome.edge_b = static_cast<std::ptrdiff_t>(of_b.begin + j);
      return true;
    }
  }
  return false;
}

/// Whether one of two regions may hold the other: what is inside of a region is inside of the box around it.
bool mayHold(const Bounds& box_a, const Bounds& box_b, double grown) {
  return box_b.contains(box_a) || box_a.grown(2 * grown).contains(box_b);
}

}  // namespace

std::optional<Outcome> collideByEdges(const PosedPair& pair, const EdgeTest& test) {
  if (arePaidFor(pair.a, pair.b)) return std::nullopt;
  const PointsOf points(pair, test.options);
  const double grown = points.grown;
  if (!(pair.error() < 0x1p850 && grown < 0x1p900)) return std::nullopt;
  Outcome outcome;
  Chains of_a(
      pair.a, [&](std::size_t i) { return points.ofA(i); }, 0),
      of_b(
          pair.b, [&](std::size_t j) { return points.ofB(j); }, grown);
  const Bounds box_a = of_a.box(), box_b = of_b.box();
  if (!box_a.meets(box_b)) return outcome;
  of_a.keepMeeting(box_b);
  of_b.keepMeeting(box_a);
  // So many pairs of boxes take half of what hierarchies cost: such a query pays for them alone.
  constexpr std::size_t kMostAnEdge = 32;
  if (of_a.size() * of_b.size() > kMostAnEdge * (pair.a.path.size() + pair.b.path.size())) return std::nullopt;
  for (const Chain& chain_a : of_a)
    for (const Chain& chain_b : of_b) {
      if (!chain_a.box.meets(chain_b.box)) continue;
      const ChainPoints points_b(chain_b.begin, chain_b.end, points);
      const unsigned near_b = points_b.edgesNear(chain_a.box.grown(grown));
      if (near_b == 0) continue;
      if (findMeetingEdges(test, chain_a, points_b, chain_b.box, near_b, points, outcome)) return outcome;
    }
  return mayHold(box_a, box_b, grown) || pair.a.ringCount() + pair.b.ringCount() > 2 ? findContainment(test.pair)
                                                                                     : outcome;
}

}  // namespace tricover::detail
