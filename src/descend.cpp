// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "strategy.h"
#include "wide.h"

namespace tricover::detail {
namespace {

/// b's centre in a's units is wrong by the mapping's own error and by rounding the difference to S; entries of R are by
/// 9U, and what they are applied to is below 4 units.
Descent describe(const PosedPair& pair, const CollideOptions& options, double lookahead, bool wants_clearance) {
  const double inverse_unit = pair.a.inverse_unit;
  const ApproxPoint center = pair.center();
  const double cx = (center.x - pair.a.origin.x()) * inverse_unit, cy = (center.y - pair.a.origin.y()) * inverse_unit;
  const double error = (center.error + kUlp * (std::abs(center.x) + std::abs(center.y))) * inverse_unit +
                       64 * kUlp * (std::abs(cx) + std::abs(cy) + 4) + kTiny;
  const double reach = pair.reach(options.margin) * inverse_unit, sum = options.margin + options.tolerance;
  return {pair,
          pair.a.hierarchy(),
          pair.b.hierarchy(),
          {pair.m00, pair.m01, pair.m10, pair.m11, cx, cy, pair.b.unit * inverse_unit, error},
          0x1p-19 + 8 * pair.defect,
          reach,
          reach + lookahead * inverse_unit,
          sum > 0 ? sum * inverse_unit * (1 - 2 * pair.scale_defect) * (1 - 0x1p-20) : -1,
          options.margin,
          options.tolerance,
          wants_clearance};
}

/// A lower bound, in a's units, of the gap between the boxes around everything, by separating axes; not positive where
/// they may meet.
double rootGap(const Descent& d) {
  const Box &a = d.a.root, &b = d.b.root;
  const UnitMap& map = d.to_a;
  const double ux = map.r00 * b.ux + map.r01 * b.uy, uy = map.r10 * b.ux + map.r11 * b.uy;
  const double dx = map.scale * (map.r00 * b.x + map.r01 * b.y) + map.tx - a.x;
  const double dy = map.scale * (map.r10 * b.x + map.r11 * b.y) + map.ty - a.y;
  const double along = b.along * map.scale, across = b.across * map.scale;
  const double c = std::abs(a.ux * ux + a.uy * uy), s = std::abs(a.ux * uy - a.uy * ux);
  const double gap = std::max(std::max(std::abs(dx * a.ux + dy * a.uy) - (a.along + along * c + across * s),
                                       std::abs(dy * a.ux - dx * a.uy) - (a.across + along * s + across * c)),
                              std::max(std::abs(dx * ux + dy * uy) - (along + a.along * c + a.across * s),
                                       std::abs(dy * ux - dx * uy) - (across + a.along * s + a.across * c)));
  return gap - d.rounding * (std::abs(dx) + std::abs(dy) + 4) - d.to_a.error;
}

/// Whether p, in the polygon's frame, is certainly outside of the box around everything.
bool outsideRoot(const PolygonData& polygon, const ApproxPoint& p) {
  const Hierarchy* hierarchy = polygon.hierarchyIfBuilt();
  if (hierarchy == nullptr) return false;
  const Box& box = hierarchy->root;
  const Vec2 d = polygon.inUnits({p.x, p.y}) - Vec2(box.x, box.y);
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
  const double radius = (pair.radiusB() + 4 * pair.error) * (1 + 16 * kUlp);
  const bool squarable = radius > 0x1p-480 && radius < 0x1p480;
  for (std::size_t r = 0; r < pair.a.ringCount(); ++r) {
    const std::size_t first = pair.a.edgeBegin(r);
    const Vec2& p = pair.a.path[first];
    const double dx = p.x() - pair.center_x, dy = p.y() - pair.center_y;
    if (squarable && dx * dx + dy * dy > radius * radius) continue;
    if (locate(PosedPair(pair.b, pair.pose_b, pair.a, pair.pose_a), p) != Location::Outside)
      return static_cast<std::ptrdiff_t>(first);
  }
  return -1;
}

}  // namespace

UnitMap inverse(const UnitMap& map) {
  const double d = 1 / (map.r00 * map.r11 - map.r01 * map.r10), scale = 1 / map.scale;
  const double r00 = map.r11 * d, r01 = -map.r01 * d, r10 = -map.r10 * d, r11 = map.r00 * d;
  return {r00, r01, r10, r11, -(r00 * map.tx + r01 * map.ty) * scale, -(r10 * map.tx + r11 * map.ty) * scale,
          scale, map.error * scale * (1 + 0x1p-10)};
}

Outcome findContainment(const PosedPair& pair) {
  Outcome outcome;
  outcome.edge_b = ringOfBInside(pair);
  if (outcome.edge_b < 0) outcome.edge_a = ringOfAInside(pair);
  outcome.collides = outcome.edge_a >= 0 || outcome.edge_b >= 0;
  return outcome;
}

Outcome collideByHierarchy(const PosedPair& pair, const CollideOptions& options, double lookahead, Wanted wanted) {
  const Descent descent = describe(pair, options, lookahead, wanted == Wanted::Clearance);
  Outcome outcome;
  const bool near = std::abs(descent.to_a.tx) + std::abs(descent.to_a.ty) < 4;  // false for NaN
  const auto &convex_a = descent.a.small_convex, &convex_b = descent.b.small_convex;
  if (convex_a && convex_b && near && wanted == Wanted::Answer && options.margin == 0) {
    const Meeting meeting = convexMeet(*convex_a, *convex_b, descent.to_a, descent.rounding);
    if (meeting != Meeting::Unknown) {
      outcome.collides = meeting == Meeting::Meet;
      return outcome;
    }
  }
  // Nothing of the regions is outside of the boxes around everything, so that no containment is left to ask for.
  const double gap = rootGap(descent);
  if (gap > descent.limit) {
    outcome.clearance = gap * pair.a.unit;
    return outcome;
  }
  // Inner discs hardly meet unless the boxes are deep in each other.
  const double deep = 0.7 * std::min<double>(descent.a.root.across, descent.b.root.across * descent.to_a.scale);
  if (near && gap < -deep && wanted != Wanted::Edges) {
    const double depth = innerDepth(descent.a.inner_discs, descent.b.inner_discs, descent.to_a, descent.rounding);
    if (depth > 0) {
      outcome.collides = true;
      outcome.clearance = depth * pair.a.unit;
      return outcome;
    }
  }
  const DescentResult found = descend(descent);
  if (found.hit) {
    outcome.collides = true;
    outcome.edge_a = found.edge_a;
    outcome.edge_b = found.edge_b;
    return outcome;
  }
  outcome = findContainment(pair);
  if (wanted == Wanted::Clearance) outcome.clearance = std::min(found.clearance * pair.a.unit, std::numeric_limits<double>::max());
  return outcome;
}

}  // namespace tricover::detail
