// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "strategy.h"

namespace tricover::detail {
namespace {

/// Largest gap, over the four axes of the two boxes, between their projections (separating axes): a lower bound of
/// their distance. Positive only if they are apart; NaN or -inf where numbers overflow, which proves nothing.
double boxGap(const Hierarchy::Node& a, const Hierarchy::Node& b, const PosedPair& pair) {
  const double bx = pair.m00 * b.ux + pair.m01 * b.uy, by = pair.m10 * b.ux + pair.m11 * b.uy;
  const double dx = pair.m00 * b.x + pair.m01 * b.y + pair.tx - a.x,
               dy = pair.m10 * b.x + pair.m11 * b.y + pair.ty - a.y;
  const double c = std::abs(a.ux * bx + a.uy * by), s = std::abs(a.ux * by - a.uy * bx);
  const double along_a = std::abs(dx * a.ux + dy * a.uy) - (a.along + b.along * c + b.across * s);
  const double across_a = std::abs(dy * a.ux - dx * a.uy) - (a.across + b.along * s + b.across * c);
  const double along_b = std::abs(dx * bx + dy * by) - (b.along + a.along * c + a.across * s);
  const double across_b = std::abs(dy * bx - dx * by) - (b.across + a.along * s + a.across * c);
  return std::max(std::max(along_a, across_a), std::max(along_b, across_b)) - pair.slack;
}

/// The position of the first edge of a ring of b that starts in a; -1 if there is none.
std::ptrdiff_t ringInside(const PosedPair& pair) {
  for (std::size_t r = 0; r < pair.b.ringCount(); ++r) {
    const std::size_t first = pair.b.edgeBegin(r);
    if (locate(pair, pair.b.path[first]) != Location::Outside) return static_cast<std::ptrdiff_t>(first);
  }
  return -1;
}

}  // namespace

Outcome findContainment(const PosedPair& pair) {
  Outcome outcome;
  outcome.edge_b = ringInside(pair);
  if (outcome.edge_b < 0) outcome.edge_a = ringInside(PosedPair(pair.b, pair.pose_b, pair.a, pair.pose_a));
  outcome.collides = outcome.edge_a >= 0 || outcome.edge_b >= 0;
  return outcome;
}

Outcome collideByHierarchy(const PosedPair& pair, const CollideOptions& options, double lookahead) {
  struct Visit {
    std::uint32_t a, b;
  };
  // A step replaces one visit by two and descends one level of one tree: never more visits than levels, 2 * 34 in each.
  Visit stack[160];
  int top = 0;
  stack[top++] = {0, 0};

  const Hierarchy &tree_a = pair.a.hierarchy(), &tree_b = pair.b.hierarchy();
  const double reach = pair.reach(options.margin);
  const double limit = reach + lookahead;
  Outcome outcome;
  double clearance = std::numeric_limits<double>::max();
  while (top > 0) {
    const Visit visit = stack[--top];
    const Hierarchy::Node &a = tree_a[visit.a], &b = tree_b[visit.b];
    const double gap = boxGap(a, b, pair);
    if (gap > limit) {
      clearance = std::min(clearance, gap);
      continue;
    }
    if (a.isLeaf() && b.isLeaf()) {
      clearance = std::min(clearance, gap > 0 ? gap : 0);
      if (gap > reach || !edgesWithin(pair, a.edge, b.edge, options.margin, options.tolerance)) continue;
      outcome.collides = true;
      outcome.edge_a = a.edge;
      outcome.edge_b = b.edge;
      return outcome;
    }
    // Both chains span boxes that meet but for `slack`: some points of them are no farther apart than the boxes are
    // thick.
    if (a.spanned && b.spanned && gap <= 0 &&
        (2 * (a.across + b.across) + 4 * pair.slack) * (1 + 2 * pair.scale_defect) <= options.tolerance) {
      outcome.collides = true;
      return outcome;
    }
    if (b.isLeaf() || (!a.isLeaf() && a.size() >= b.size())) {
      stack[top++] = {a.right, visit.b};
      stack[top++] = {visit.a + 1, visit.b};
    } else {
      stack[top++] = {visit.a, b.right};
      stack[top++] = {visit.a, visit.b + 1};
    }
  }
  outcome = findContainment(pair);
  outcome.clearance = clearance;
  return outcome;
}

}  // namespace tricover::detail
