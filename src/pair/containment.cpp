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

/// A disc around a's region in b's frame, rounded outwards: poses' defects grow its radius.
Place discOfA(const PosedPair& pair) {
  const ApproxPoint center = seenFromA(pair.back(), pair.a.origin).approx;
  return {center.x, center.y,
          (pair.a.reach * (1 + 2.1 * kLargestDefect) + 4 * center.error) * (1 + 16 * kUnitRoundoff)};
}

bool holds(const Place& disc, const Vec2& p) {
  const double dx = p.x() - disc.x, dy = p.y() - disc.y;
  return !(squarable(disc.error) && dx * dx + dy * dy > disc.error * disc.error);
}

/// The first edge of the first ring of b that starts in a, on its boundary or inside; kNoEdge if there is none. Most
/// starts are outside of the disc or of the box around a; the others are located.
EdgePosition ringOfBInside(const PosedPair& pair, Location least) {
  const Place disc = discOfA(pair);
  std::size_t located = 0;
  const auto starts_inside = [&](EdgePosition edge) {
    const Vec2& p = pair.b.path[edge];
    return holds(disc, p) && !outsideRoot(pair.a, seenFromA(pair, p).approx) &&
           (++located, locateInA(pair, p) >= least);
  };
  if (const RingStarts* starts = ringStarts(pair.b)) {
    for (const EdgePosition edge : starts->near({disc.x, disc.y}, disc.error))
      if (starts_inside(edge)) return edge;
    return kNoEdge;
  }
  const std::size_t rings = pair.b.ringCount();
  for (std::size_t ring = 0; ring < rings; ++ring)
    if (const EdgePosition edge = pair.b.edgeBegin(ring); starts_inside(edge)) return edge;
  countRings(pair.b, rings, located);
  return kNoEdge;
}

}  // namespace

EdgePosition ringInside(const PosedPair& pair) { return ringOfBInside(pair, Location::Inside); }

Outcome findContainment(const PosedPair& pair) {
  Outcome outcome;
  // A segment holds nothing that doesn't meet it.
  if (!pair.a.isDegenerate()) outcome.edge_b = ringOfBInside(pair, Location::Boundary);
  if (outcome.edge_b == kNoEdge && !pair.b.isDegenerate())
    outcome.edge_a = ringOfBInside(pair.back(), Location::Boundary);
  outcome.collides = outcome.edge_a != kNoEdge || outcome.edge_b != kNoEdge;
  return outcome;
}

}  // namespace tricover::detail
