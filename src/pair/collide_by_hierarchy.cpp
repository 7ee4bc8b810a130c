// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "hierarchy/wide.h"
#include "pair/edge_pairs.h"
#include "pair/strategy.h"

namespace tricover::detail {
namespace {

/// From b's units to a's. b's centre in a's units is wrong by the mapping's own error and by rounding the difference to
/// S; entries of R are by 9U, and what they are applied to is below 4 units.
UnitMap mapUnits(const PosedPair& pair) {
  const double inverse_unit = pair.a.inverse_unit;
  const ApproxPoint center = pair.center();
  const double cx = (center.x - pair.a.origin.x()) * inverse_unit, cy = (center.y - pair.a.origin.y()) * inverse_unit;
  // In any direction, so once and a half what either coordinate is wrong by.
  const double rounding =
      1.5 * (center.error + kUnitRoundoff * (std::abs(center.x) + std::abs(center.y))) * inverse_unit +
      64 * kUnitRoundoff * (std::abs(cx) + std::abs(cy) + 4) + kTiny;
  // The largest of polygons are more than their unit: nothing is known of those.
  const bool fits = pair.a.radius <= pair.a.unit && pair.b.radius <= pair.b.unit;
  const double error = fits ? rounding : std::numeric_limits<double>::infinity();
  return {pair.m00, pair.m01, pair.m10, pair.m11, cx, cy, pair.b.unit * inverse_unit, error};
}

/// Of a gap between boxes, see Descent.
double roundingOf(const PosedPair& pair) { return 0x1p-19 + 8 * pair.defect; }

Descent describe(const PosedPair& pair, const UnitMap& to_a, double rounding, const CollideOptions& options,
                 double lookahead, bool wants_clearance) {
  const double unit = pair.a.inverse_unit, sum = options.margin + options.tolerance;
  const double accept = sum > 0 ? sum * unit * (1 - 2 * pair.scale_defect) * (1 - 0x1p-20) : -1;
  const double reach = pair.reach(options.margin) * unit, limit = reach + lookahead * unit;
  return {pair,   hierarchyOf(pair.a), hierarchyOf(pair.b), to_a,           rounding, reach, limit,
          accept, options.margin,     options.tolerance,  wants_clearance};
}

/// A lower bound, in a's units, of the gap between the boxes around everything, by separating axes; not positive where
/// they may meet.
double rootGap(const Box& a, const Box& b, const UnitMap& map, double rounding) {
  const double ux = map.r00 * b.ux + map.r01 * b.uy, uy = map.r10 * b.ux + map.r11 * b.uy;
  const double dx = map.scale * (map.r00 * b.x + map.r01 * b.y) + map.tx - a.x;
  const double dy = map.scale * (map.r10 * b.x + map.r11 * b.y) + map.ty - a.y;
  const double along = b.along * map.scale, across = b.across * map.scale;
  const double c = std::abs(a.ux * ux + a.uy * uy), s = std::abs(a.ux * uy - a.uy * ux);
  const double gap = std::max(std::max(std::abs(dx * a.ux + dy * a.uy) - (a.along + along * c + across * s),
                                       std::abs(dy * a.ux - dx * a.uy) - (a.across + along * s + across * c)),
                              std::max(std::abs(dx * ux + dy * uy) - (along + a.along * c + a.across * s),
                                       std::abs(dy * ux - dx * uy) - (across + a.along * s + a.across * c)));
  return gap - rounding * (std::abs(dx) + std::abs(dy) + 4) - map.error;
}

/// Whether p, in the polygon's frame, is certainly outside of the box around everything.
bool outsideRoot(const PolygonData& polygon, const ApproxPoint& p) {
  const Hierarchy* hierarchy = hierarchyIfBuilt(polygon);
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

UnitMap inverse(const UnitMap& map) {
  const double d = 1 / (map.r00 * map.r11 - map.r01 * map.r10), scale = 1 / map.scale;
  const double r00 = map.r11 * d, r01 = -map.r01 * d, r10 = -map.r10 * d, r11 = map.r00 * d;
  return {r00,
          r01,
          r10,
          r11,
          -(r00 * map.tx + r01 * map.ty) * scale,
          -(r10 * map.tx + r11 * map.ty) * scale,
          scale,
          map.error * scale * (1 + 0x1p-10)};
}

void visitPairs(const PosedPair& pair, double limit, const PairVisitor& visitor) {
  visitPairs(describe(pair, mapUnits(pair), roundingOf(pair), {}, limit, false), visitor);
}

Outcome findContainment(const PosedPair& pair) {
  Outcome outcome;
  outcome.edge_b = ringOfBInside(pair);
  if (outcome.edge_b < 0) outcome.edge_a = ringOfAInside(pair);
  outcome.collides = outcome.edge_a >= 0 || outcome.edge_b >= 0;
  return outcome;
}

Outcome collideByHierarchy(const PosedPair& pair, const CollideOptions& options, double lookahead, Wanted wanted) {
  const Hierarchy &a = hierarchyOf(pair.a), &b = hierarchyOf(pair.b);
  const UnitMap map = mapUnits(pair);
  const double rounding = roundingOf(pair);
  Outcome outcome;
  // Nothing of the regions is outside of the boxes around everything, so that no containment is left to ask for.
  const double gap = rootGap(a.root, b.root, map, rounding);
  if (gap * pair.a.unit > pair.reach(options.margin) + lookahead) {
    outcome.clearance = gap * pair.a.unit;
    return outcome;
  }
  const bool near = std::abs(map.tx) + std::abs(map.ty) < 4;  // false for NaN
  if (a.small_convex && b.small_convex && near && wanted == Wanted::Answer && options.margin == 0) {
    const Meeting meeting = convexMeet(*a.small_convex, *b.small_convex, map, rounding);
    if (meeting != Meeting::Unknown) {
      outcome.collides = meeting == Meeting::Meet;
      return outcome;
    }
  }
  // Inner discs hardly meet unless the boxes are deep in each other.
  const double deep = 0.7 * std::min<double>(a.root.across, b.root.across * map.scale);
  if (near && gap < -deep && wanted != Wanted::Edges) {
    const double depth = innerDepth(a.inner_discs, b.inner_discs, map, rounding);
    if (depth > 0) {
      outcome.collides = true;
      outcome.clearance = depth * pair.a.unit;
      return outcome;
    }
  }
  const bool wants_clearance = wanted == Wanted::Clearance;
  const DescentResult found = descend(describe(pair, map, rounding, options, lookahead, wants_clearance));
  if (found.hit) {
    outcome.collides = true;
    outcome.edge_a = found.edge_a;
    outcome.edge_b = found.edge_b;
    return outcome;
  }
  outcome = findContainment(pair);
  if (wants_clearance) outcome.clearance = std::min(found.clearance * pair.a.unit, std::numeric_limits<double>::max());
  return outcome;
}

}  // namespace tricover::detail
