// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "hierarchy/placement.h"
#include "hierarchy/simd.h"
#include "pair/edge_test.h"
#include "pair/outcome.h"
#include "pair/root_box.h"
#include "tricover/collide.h"

namespace tricover::detail {

/// What a query wants to know beside the answer: nothing, how certain it is, or the edges of a hit. The less, the
/// shorter the ways to it.
enum class Wanted { Answer, Clearance, Edges };

/// Two small convex polygons: by floats or, where these don't tell, by the edge that they find best, in doubles.
Meeting smallConvexMeet(const UnitPlacement& at, const EdgeTest& test);

/// What the two boxes around everything, few edges and inner discs tell, before the trees are searched. Lengths are
/// in a's units: `limit` is that of gaps that matter, `clearance` is that of the answer. Where other boxes are known to
/// meet (`boxes_meet`), those around few edges hardly part them any more.
[[gnu::always_inline]] inline Meeting meetAtOnce(const UnitPlacement& at, double limit, Wanted wanted,
                                                 const EdgeTest& test, double& clearance, bool boxes_meet) {
  const Hierarchy &a = hierarchyOf(test.a), &b = hierarchyOf(test.b);
  const auto are_near = [&] { return std::abs(at.map.tx) + std::abs(at.map.ty) < 4; };  // false for NaN
  const auto have_few_edges = [&] { return wanted == Wanted::Answer && limit == 0 && areSmall(a, b); };
  // Nothing of the regions is outside of the boxes around everything, so that no containment is left to ask for.
  const bool is_asked = !(boxes_meet && are_near() && have_few_edges());
  const double gap = is_asked ? rootGap(a.root, b.root, at.map, at.rounding) : 0;
  if (gap > limit) {
    clearance = gap;
    return Meeting::Apart;
  }
  if (!are_near() || wanted == Wanted::Edges) return Meeting::Unknown;
  if (have_few_edges()) {
    // They serve the next query, before its boxes.
    innerDiscsIfPaid(test.a), innerDiscsIfPaid(test.b);
    return a.small_convex && b.small_convex
               ? smallConvexMeet(at, test)
               : fewEdgesMeet(*a.small, *b.small, at.map, at.rounding, {&test, &EdgeTest::meet});
  }
  // Inner discs hardly meet unless the boxes are deep in each other.
  const double deep = 0.7 * std::min<double>(a.root.across, b.root.across * at.map.scale);
  if (!(gap < -deep)) return Meeting::Unknown;
  const InnerDiscs *discs_a = innerDiscsIfPaid(test.a), *discs_b = innerDiscsIfPaid(test.b);
  if (discs_a == nullptr || discs_b == nullptr) return Meeting::Unknown;
  const double depth = innerDepth(*discs_a, *discs_b, at.map, at.rounding);
  if (!(depth > 0)) return Meeting::Unknown;
  clearance = depth;
  return Meeting::Meet;
}

/// The rest of collideByHierarchy(): both trees descended, and containment.
Outcome searchTrees(const UnitPlacement& at, const EdgeTest& test, double lookahead, Wanted wanted);

/// Of two degenerate polygons, by no tree, or a point b, by a's tree alone.
Outcome collideDegenerate(const UnitPlacement& at, const EdgeTest& test, double lookahead, Wanted wanted);

/// The default strategy. Whatever is farther apart than the margin by `lookahead`, a length in a's frame, isn't looked
/// at, so that a clearance of at least that much is found if there is one. The pair must be in order (inOrder()), and
/// its bounding discs may meet. Inlined, because what discs have computed is in registers.
[[gnu::always_inline]] inline Outcome collideByHierarchy(const UnitPlacement& at, const EdgeTest& test,
                                                         double lookahead, Wanted wanted, bool boxes_meet = false) {
  if (test.b.isDegenerate() && (test.b.isPoint() || test.a.isDegenerate()))
    return collideDegenerate(at, test, lookahead, wanted);
  const double limit = at.reach(test.options.margin) + lookahead * at.inverse_unit;
  Outcome outcome;
  const Meeting meeting = meetAtOnce(at, limit, wanted, test, outcome.clearance, boxes_meet);
  if (meeting == Meeting::Unknown) return searchTrees(at, test, lookahead, wanted);
  outcome.collides = meeting == Meeting::Meet;
  outcome.clearance *= test.a.unit;
  outcome.by = Outcome::By::Boxes;
  return outcome;
}

/// The same for a pair whose relative pose is known.
Outcome collideByHierarchy(const PosedPair& pair, const CollideOptions& options, double lookahead, Wanted wanted);

}  // namespace tricover::detail
