// SPDX-License-Identifier: BSD-3-Clause
#include "pair/containment.h"

#include <cmath>

#include "hierarchy/hierarchy.h"

namespace tricover::detail {
namespace {

/// Whether p, in the polygon's frame, is certainly outside of the box around everything.
bool outsideRoot(const PolygonData& polygon, const ApproxPoint& p) {
  const Hierarchy* hierarchy = hierarchyIfBuilt(polygon);
  if (hierarchy == nullptr) return false;
  const Box& box = hierarchy->root;
  const Vec2 d = polygon.inUnits({p.x, p.y}) - Vec2(box.x, box.y);
  // p is wrong by `error` in either coordinate, 1.4143 of it along an axis. 2^-40: d is below 4 where it counts and
  // rounded a few times, and the box's axis is of unit length but for the room that its extents have been given.
  const double error = 2 * p.error * polygon.inverse_unit + 0x1p-40;
  return std::abs(d.x() * box.ux + d.y() * box.uy) > box.along + error ||
         std::abs(d.y() * box.ux - d.x() * box.uy) > box.across + error;
}

/// The position of the first edge of a ring of b that starts in a; -1 if there is none.
std::ptrdiff_t ringOfBInside(const PosedPair& pair) {
  for (std::size_t r = 0; r < pair.b.ringCount(); ++r) {
    const std::size_t first = pair.b.edgeBegin(r);
    const Vec2& p = pair.b.path[first];
    if (outsideRoot(pair.a, pair.fromB(p))) continue;
    if (locate(pair, p) != Location::Outside) return static_cast<std::ptrdiff_t>(first);
  }
  return -1;
}

/// The same for a ring of a in b. Most starts are outside of b's disc, which is known in a's frame.
std::ptrdiff_t ringOfAInside(const PosedPair& pair) {
  const double radius = (pair.radiusB() + 4 * pair.error) * (1 + 16 * kUnitRoundoff);
  for (std::size_t r = 0; r < pair.a.ringCount(); ++r) {
    const std::size_t first = pair.a.edgeBegin(r);
    const Vec2& p = pair.a.path[first];
    const double dx = p.x() - pair.center_x, dy = p.y() - pair.center_y;
    if (squarable(radius) && dx * dx + dy * dy > radius * radius) continue;
    if (locate(PosedPair(pair.b, pair.pose_b, pair.a, pair.pose_a), p) != Location::Outside)
      return static_cast<std::ptrdiff_t>(first);
  }
  return -1;
}

}  // namespace

Outcome findContainment(const PosedPair& pair) {
  Outcome outcome;
  // A segment holds nothing that doesn't meet it.
  if (!pair.a.hasSpine()) outcome.edge_b = ringOfBInside(pair);
  if (outcome.edge_b < 0 && !pair.b.hasSpine()) outcome.edge_a = ringOfAInside(pair);
  outcome.collides = outcome.edge_a >= 0 || outcome.edge_b >= 0;
  return outcome;
}

}  // namespace tricover::detail
