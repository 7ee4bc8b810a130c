// SPDX-License-Identifier: BSD-3-Clause
#include "pair/containment.h"

#include <cstdint>

#include "hierarchy/hierarchy.h"
#include "pair/ring_starts.h"
#include "pair/root_box.h"

namespace tricover::detail {
namespace {

/// Whether p, in the polygon's frame, is certainly outside of the box around everything.
bool outsideRoot(const PolygonData& polygon, const ApproxPoint& p) {
  const Hierarchy* hierarchy = topIfBuilt(polygon);
  if (hierarchy == nullptr) return false;
  const Vec2 at = polygon.inUnits({p.x, p.y});
  // p is wrong by `error` in either coordinate.
  return distanceFromRoot(hierarchy->region, {at.x(), at.y(), 1.5 * p.error * polygon.inverse_unit}) > 0;
}

/// A disc around b's region in a's frame, rounded outwards: poses' defects grow its radius.
struct DiscOfB {
  explicit DiscOfB(const PosedPair& pair) {
    const ApproxPoint center = seenFromA(pair, pair.b.origin).approx;
    x = center.x;
    y = center.y;
    radius = (pair.b.reach * (1 + 2.1 * kLargestDefect) + 4 * center.error) * (1 + 16 * kUnitRoundoff);
  }

  bool holds(const Vec2& p) const {
    const double dx = p.x() - x, dy = p.y() - y;
    return !(squarable(radius) && dx * dx + dy * dy > radius * radius);
  }

  double x, y, radius;
};

/// The first edge of the first ring that starts inside; kNoEdge if there is none. `disc()` is around all
/// starts that may be inside. Those that isNear(p) leaves are located.
template <typename MakeDisc, typename IsNear, typename IsInside>
[[gnu::always_inline]] inline EdgePosition firstInside(const PolygonData& polygon, MakeDisc disc, IsNear isNear,
                                                       IsInside isInside) {
  std::size_t located = 0;
  const auto starts_inside = [&](EdgePosition edge) {
    const Vec2& p = polygon.path[edge];
    return isNear(p) && (++located, isInside(p));
  };
  if (const RingStarts* starts = ringStarts(polygon)) {
    const DiscOfB around = disc();
    for (const EdgePosition edge : starts->near({around.x, around.y}, around.radius))
      if (starts_inside(edge)) return edge;
    return kNoEdge;
  }
  for (std::size_t ring = 0; ring < polygon.ringCount(); ++ring)
    if (const EdgePosition edge = polygon.edgeBegin(ring); starts_inside(edge)) return edge;
  countRings(polygon, polygon.ringCount(), located);
  return kNoEdge;
}

/// Of b in a, on its boundary or inside.
EdgePosition ringOfBInside(const PosedPair& pair, Location least) {
  return firstInside(
      pair.b, [&] { return DiscOfB(pair.back()); },
      [&](const Vec2& p) { return !outsideRoot(pair.a, seenFromA(pair, p).approx); },
      [&](const Vec2& p) { return locateInA(pair, p) >= least; });
}

/// Of a in b. Most starts are outside of b's disc, which is known in a's frame.
EdgePosition ringOfAInside(const PosedPair& pair) {
  const DiscOfB disc(pair);
  return firstInside(
      pair.a, [&] { return disc; }, [&](const Vec2& p) { return disc.holds(p); },
      [&](const Vec2& p) { return locateInA(pair.back(), p) != Location::Outside; });
}

}  // namespace

EdgePosition ringInside(const PosedPair& pair) { return ringOfBInside(pair, Location::Inside); }

Outcome findContainment(const PosedPair& pair) {
  Outcome outcome;
  // A segment holds nothing that doesn't meet it.
  if (!pair.a.isDegenerate()) outcome.edge_b = ringOfBInside(pair, Location::Boundary);
  if (outcome.edge_b == kNoEdge && !pair.b.isDegenerate()) outcome.edge_a = ringOfAInside(pair);
  outcome.collides = outcome.edge_a != kNoEdge || outcome.edge_b != kNoEdge;
  return outcome;
}

}  // namespace tricover::detail
