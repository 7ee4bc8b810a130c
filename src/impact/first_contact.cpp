// SPDX-License-Identifier: BSD-3-Clause
// The first contact of two motions, with a margin of 0 or more.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "impact/impact_options.h"
#include "impact/impact_solvers.h"
#include "pair/collide_by_hierarchy.h"
#include "pair/kernel_order.h"
#include "polygon/convexity.h"

namespace tricover::detail {
namespace {

/// From the pair's frame at `time` to the world.
Vec2 toWorld(const MovingPair& pair, double time, const Vec2& p) {
  const Motion& motion_a = *pair.a.motion;
  const Vec2 path = pathOf(motion_a).at(time) / 4;
  // Infinite only if the sum is, and not because its parts are.
  const Vec2 quarter = motion_a.start.linear() * (pair.a.pivot / 4) + motion_a.start.translation() / 4 + path;
  return (quarter + p * (pair.length / 4) * pair.expansion) * 4;
}

/// The axis of an edge, or normal to it, that separates two edges best, for edges so near that the difference of their
/// nearest points is mostly rounding. Where the edges don't tell axis or side, the origins do.
Vec2 normalOfTouch(const MovingEdge& a, const MovingEdge& b, const Vec2& between_origins, double error) {
  const Vec2 half_a = a.half(), half_b = b.half(), middles = (b.from() + half_b) - (a.from() + half_a);
  double widest = -std::numeric_limits<double>::infinity();
  Vec2 best(1, 0);
  for (const Vec2& half : {half_a, half_b}) {
    const double size = half.lpNorm<Eigen::Infinity>();  // squares may underflow
    const Vec2 axis = size > 0 ? (half / size).normalized() : Vec2(1, 0);
    for (const Vec2& normal : {Vec2(-axis.y(), axis.x()), axis}) {
      const double apart = normal.dot(middles);
      const double gap = std::abs(apart) - std::abs(normal.dot(half_a)) - std::abs(normal.dot(half_b));
      const bool alike = std::abs(gap - widest) <= error;
      if (alike ? std::abs(normal.dot(between_origins)) <= std::abs(best.dot(between_origins)) : gap < widest) continue;
      widest = gap;
      best = (std::abs(apart) > error ? apart : normal.dot(between_origins)) < 0 ? Vec2(-normal) : normal;
    }
  }
  return best;
}

/// The number of an edge at a point of it.
EdgeIndex givenEdge(const Mover& mover, EdgePosition position, const MovingEdge& edge, const Vec2& point) {
  if (mover.given == mover.polygon) return givenEdge(*mover.given, *mover.polygon, position, 0);
  const Vec2 along = edge.to() - edge.from();
  const double part = (point - edge.from()).dot(along) / along.squaredNorm();
  return givenEdge(*mover.given, *mover.polygon, position, std::clamp(part, 0.0, 1.0));
}

/// One polygon holds a ring of the other at time 0, and no edges meet.
Impact describeContainment(const MovingPair& pair, const FirstContact& found) {
  const Vec2 between = pair.a.places(0, 0).originTo(pair.b.places(0, 0));
  Impact impact{0, Vec2::Zero(), between.isZero(0) ? Vec2(1, 0) : between.stableNormalized(), -1, -1};
  const auto vertex = [&](const Mover& mover, EdgePosition edge) {
    impact.point = mover.motion->start * mover.polygon->path[edge];
    return givenEdge(*mover.given, *mover.polygon, edge, 0);
  };
  if (found.edge_a != kNoEdge) impact.edge_a = vertex(pair.a, found.edge_a);
  if (found.edge_b != kNoEdge) impact.edge_b = vertex(pair.b, found.edge_b);
  return impact;
}

Impact describe(const MovingPair& pair, const FirstContact& found) {
  if (found.edge_a == kNoEdge || found.edge_b == kNoEdge) return describeContainment(pair, found);
  const Places places_a = pair.a.places(found.time, found.time), places_b = pair.b.places(found.time, found.time);
  const MovingEdge a = pair.a.ends(places_a, 0, found.edge_a), b = pair.b.ends(places_b, 0, found.edge_b);
  const NearestPoints nearest(a, b, pair.error);
  const Vec2 normal = nearest.distance > 0x1p20 * pair.error
                          ? Vec2(nearest.on_b - nearest.on_a).stableNormalized()
                          : normalOfTouch(a, b, places_a.originTo(places_b), pair.error);
  assert(0 <= found.time && found.time <= 1 && std::abs(normal.norm() - 1) < 0x1p-40);
  return {found.time,
          toWorld(pair, found.time, 0.5 * (nearest.on_a + nearest.on_b)),
          normal,
          givenEdge(pair.a, found.edge_a, a, nearest.on_a),
          givenEdge(pair.b, found.edge_b, b, nearest.on_b),
          found.budget_ended};
}

/// Time 0 is collide()'s. A pair that is apart there meets at its edges first.
FirstContact collideAtStart(const MovingPair& pair, double begin, double) {
  if (begin > 0) return FirstContact::unknown(begin);
  const PosedPair posed(*pair.a.polygon, pair.a.motion->start, *pair.b.polygon, pair.b.motion->start);
  const double defect = defectOf(pair.a.motion->start, pair.b.motion->start);
  if (BodyInField(posed, defect).gap(pair.given_margin) > 0) return FirstContact::unknown(0);
  const Outcome outcome = collideByHierarchy(posed, {pair.given_margin}, 0, Wanted::Edges);
  if (!outcome.collides) return FirstContact::unknown(0);
  return {FirstContact::Verdict::Touch, 0, outcome.edge_a, outcome.edge_b};
}

/// One method for the first contact. What it leaves unknown is known up to a time, at which the next one begins.
struct Solver {
  bool (*fits)(const MovingPair& pair);
  FirstContact (*solve)(const MovingPair& pair, double begin, double time_error);
};

bool fitsAll(const MovingPair&) { return true; }

/// Each is called for what those before it leave unknown. The second is the only one that sees what touches or overlaps
/// at time 0; those after it take for granted that nothing does. The last one always knows.
constexpr Solver kSolvers[] = {
    {isConvexPair, advanceAlongAxis},
    {fitsAll, collideAtStart},
    {haveFewVertices, followVertices},
    {fitsAll, searchBoxes},
};

std::optional<Impact> impactInOrder(const PolygonData& a, const Motion& motion_a, const PolygonData& b,
                                    const Motion& motion_b, const ImpactOptions& options) {
  Impact impact;
  FirstContact found = slideConvex(a, motion_a, b, motion_b, options.margin, impact);
  if (found.verdict == FirstContact::Verdict::Touch) return impact;
  if (!found.isOpen()) return std::nullopt;
  MovingPair pair(a, motion_a, b, motion_b, options.margin);
  if (pair.discsStayApart()) return std::nullopt;
  pair.prepare();
  for (const Solver& solver : kSolvers)
    if (found.isOpen() && solver.fits(pair)) found = solver.solve(pair, found.time, options.time_error);
  if (found.verdict == FirstContact::Verdict::Never) return std::nullopt;
  return describe(pair, found);
}

}  // namespace

std::optional<Impact> impactOf(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b,
                               const ImpactOptions& options) {
  return inKernelOrder(
      dataOf(a), motion_a, dataOf(b), motion_b,
      [&](const auto&... operands) { return impactInOrder(operands..., options); }, swapOperands);
}

void swapOperands(std::optional<Impact>& impact) {
  if (!impact) return;
  impact->normal = -impact->normal;
  std::swap(impact->edge_a, impact->edge_b);
}

}  // namespace tricover::detail
