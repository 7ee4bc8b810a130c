// SPDX-License-Identifier: BSD-3-Clause
#include "pair/collide_by_edges.h"

#include <algorithm>
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
    if (hierarchyIfBuilt(*polygon) == nullptr) left += polygon->hierarchy_rent.left(hierarchyPrice(*polygon));
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
  const Bounds& box() const { return box_; }

  /// Leaves those that meet a box.
  void keepMeeting(const Bounds& box) {
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

/// The edges of one chain that meet a box.
template <typename Points>
struct NearEdges {
  NearEdges(const Chain& chain, Points point, double grown, const Bounds& near) {
    Double2 p = point(chain.begin);
    for (std::size_t e = chain.begin; e < chain.end; ++e) {
      const Double2 q = point(e + 1);
      const Bounds box = Bounds::between(smaller(p, q) - grown, larger(p, q) + grown);
      if (box.meets(near)) boxes[count] = box, edges[count++] = e;
      p = q;
    }
  }

  Bounds boxes[Chain::kMost];
  std::size_t edges[Chain::kMost], count = 0;
};

bool findMeetingEdges(const EdgeTest& test, const Chain& chain_a, const Chain& chain_b, double grown,
                      Outcome& outcome) {
  const NearEdges of_b(chain_b, PointsOfB{test.pair()}, grown, chain_a.box);
  if (of_b.count == 0) return false;
  const NearEdges of_a(chain_a, PointsOfA{test.pair()}, 0, chain_b.box);
  for (std::size_t i = 0; i < of_a.count; ++i)
    for (std::size_t j = 0; j < of_b.count; ++j)
      if (of_a.boxes[i].meets(of_b.boxes[j]) && test(of_a.edges[i], of_b.edges[j])) {
        outcome.collides = true;
        outcome.edge_a = static_cast<std::ptrdiff_t>(of_a.edges[i]);
        outcome.edge_b = static_cast<std::ptrdiff_t>(of_b.edges[j]);
        return true;
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
  for (const Chain& chain_a : of_a)
    for (const Chain& chain_b : of_b)
      if (chain_a.box.meets(chain_b.box) && findMeetingEdges(test, chain_a, chain_b, grown, outcome)) return outcome;
  // What is inside of a region is inside of the box around it.
  return box_b.contains(box_a) || box_a.grown(2 * grown).contains(box_b) || test.a.ringCount() + test.b.ringCount() > 2
             ? findContainment(pair)
             : outcome;
}

}  // namespace tricover::detail
