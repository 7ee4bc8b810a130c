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
/// and, of a ring that may be inside, those of the other one. The boxes around edges say nothing about a complement.
bool arePaidFor(const PolygonData& a, const PolygonData& b) {
  if (a.fill.is_complement || b.fill.is_complement) return true;
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
  static constexpr EdgePosition kMost = 8;

  EdgePosition begin, end;
  Bounds box;
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
      const EdgePosition end = polygon.edgeEnd(ring);
      Double2 p = point(polygon.edgeBegin(ring));
      for (EdgePosition e = polygon.edgeBegin(ring); e < end; ++chain) {
        const EdgePosition begin = e, last = std::min(e + Chain::kMost, end);
        Double2 low = p, high = p;
        while (e < last) {
          p = point(++e);
          low = smaller(low, p);
          high = larger(high, p);
        }
        *chain = {begin, last, Bounds::between(low - grown, high + grown)};
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

/// Tests those edges whose boxes meet. Boxes of b's edges are `grown`, as those of its chains.
bool findMeetingEdges(const EdgeTest& test, const Chain& chain_a, const Chain& chain_b, double grown,
                      Outcome& outcome) {
  const PosedPair& pair = test.pair;
  Chain edges_b[Chain::kMost], *end_b = edges_b;
  Double2 to = pair.atB(pair.b.path[chain_b.begin]);
  for (std::uint32_t j = chain_b.begin; j < chain_b.end; ++j) {
    const Double2 from = to;
    to = pair.atB(pair.b.path[j + 1]);
    const Bounds box = Bounds::between(smaller(from, to) - grown, larger(from, to) + grown);
    if (box.meets(chain_a.box)) *end_b++ = {j, j + 1, box};
  }
  if (end_b == edges_b) return false;
  to = pair.atA(pair.a.path[chain_a.begin]);
  for (std::uint32_t i = chain_a.begin; i < chain_a.end; ++i) {
    const Double2 from = to;
    to = pair.atA(pair.a.path[i + 1]);
    const Bounds box = Bounds::between(smaller(from, to), larger(from, to));
    for (const Chain* edge_b = edges_b; edge_b != end_b; ++edge_b) {
      if (!box.meets(edge_b->box) || !test(i, edge_b->begin)) continue;
      outcome.collides = true;
      outcome.edge_a = i;
      outcome.edge_b = edge_b->begin;
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

std::optional<Outcome> collideByEdges(const EdgeTest& test) {
  const PosedPair& pair = test.pair;
  if (arePaidFor(pair.a, pair.b)) return std::nullopt;
  // More than two points are off in either coordinate, and than growing a box rounds: that is at most an ulp of the
  // pair's size, a fifth of the error, and one of the margin.
  const double grown = (2 * pair.pointError() + test.options.margin) * (1 + 4 * kUnitRoundoff);
  if (!(pair.error() < 0x1p850 && grown < 0x1p900)) return std::nullopt;
  Outcome outcome;
  Chains of_a(
      pair.a, [&](std::size_t i) { return pair.atA(pair.a.path[i]); }, 0),
      of_b(
          pair.b, [&](std::size_t j) { return pair.atB(pair.b.path[j]); }, grown);
  const Bounds box_a = of_a.box(), box_b = of_b.box();
  if (!box_a.meets(box_b)) return outcome;
  of_a.keepMeeting(box_b);
  of_b.keepMeeting(box_a);
  // So many pairs of boxes take half of what hierarchies cost: such a query pays for them alone.
  constexpr std::size_t kMostAnEdge = 32;
  if (of_a.size() * of_b.size() > kMostAnEdge * (pair.a.path.size() + pair.b.path.size())) return std::nullopt;
  for (const Chain& chain_a : of_a)
    for (const Chain& chain_b : of_b)
      if (chain_a.box.meets(chain_b.box) && findMeetingEdges(test, chain_a, chain_b, grown, outcome)) return outcome;
  return mayHold(box_a, box_b, grown) || pair.a.ringCount() + pair.b.ringCount() > 2 ? findContainment(pair) : outcome;
}

}  // namespace tricover::detail
