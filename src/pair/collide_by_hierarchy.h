// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "hierarchy/simd.h"
#include "pair/discs.h"
#include "pair/edge_test.h"
#include "pair/meet_in_field.h"
#include "pair/outcome.h"
#include "pair/posed_pair.h"
#include "pair/root_box.h"
#include "tricover/collide_options.h"

namespace tricover::detail {

/// A query wants the answer alone, or how certain it is, too, or the edges of a hit. The less it wants, the shorter the
/// ways to it.
enum class Wanted { Answer, Clearance, Edges };

/// What the two boxes around everything, few edges and inner discs tell, before the trees are searched. Lengths are
/// in a's units: `limit` is that of gaps that matter, `clearance` is that of the answer.
[[gnu::always_inline]] inline Meeting meetAtOnce(const UnitMap& at, double limit, Wanted wanted, const EdgeTest& test,
                                                 double& clearance) {
  const Hierarchy &a = topOf(test.a), &b = topOf(test.b);
  // Nothing of the regions is outside of the boxes around everything, so that no containment is left to ask for.
  const double gap = rootGap(a.region, b.region, at);
  if (gap > limit) {
    clearance = gap;
    return Meeting::Apart;
  }
  const bool are_near = std::abs(at.tx) + std::abs(at.ty) < 4;  // false for NaN
  if (!are_near || wanted == Wanted::Edges) return Meeting::Unknown;
  if (wanted == Wanted::Answer && limit == 0 && areSmall(a, b)) {
    const Meeting meeting = fewEdgesMeet(*a.small, *b.small, at, {&test, &EdgeTest::meet});
    // Inner discs serve the next query that meets, before its boxes; of one that doesn't they tell nothing.
    if (meeting == Meeting::Meet) innerDiscsIfPaid(test.a), innerDiscsIfPaid(test.b);
    return meeting;
  }
  // Inner discs hardly meet unless the boxes are deep in each other.
  const double deep = 0.7 * std::min<double>(a.region.across, b.region.across * at.scale);
  if (!(gap < -deep)) return Meeting::Unknown;
  const InnerDiscs *discs_a = innerDiscsIfPaid(test.a), *discs_b = innerDiscsIfPaid(test.b);
  if (discs_a == nullptr || discs_b == nullptr) return Meeting::Unknown;
  const double depth = innerDepth(*discs_a, *discs_b, at);
  if (!(depth > 0)) return Meeting::Unknown;
  clearance = depth;
  return Meeting::Meet;
}

/// The rest of collideByHierarchy(): both trees descended, and containment.
Outcome searchTrees(const UnitMap& at, const EdgeTest& test, double lookahead, Wanted wanted);

/// Of two degenerate polygons, by no tree, or a point b, by a's tree alone.
Outcome collideDegenerate(const UnitMap& at, const EdgeTest& test, double lookahead, Wanted wanted);

/// By trees, once they are paid for. Whatever is farther apart than the margin by `lookahead` isn't looked at, so that
/// a clearance of at least that much is found if there is one. The pair must be in order (inOrder()), and its bounding
/// discs may meet. Inlined, because what discs have computed is in registers.
[[gnu::always_inline]] inline Outcome collideByHierarchy(const UnitMap& at, const EdgeTest& test, double lookahead,
                                                         Wanted wanted) {
  if (test.b.isDegenerate() && (test.b.isPoint() || test.a.isDegenerate()))
    return collideDegenerate(at, test, lookahead, wanted);
  const double limit = at.reach(test.options.margin) + lookahead * at.inverse_unit;
  Outcome outcome;
  Meeting meeting = Meeting::Unknown;
  // A body that is small beside a map. Without the field the tree is descended, and windings are counted.
  constexpr std::size_t kWithoutField = 256;
  if (isSmallBeside(test.a, test.b) && wanted != Wanted::Edges)
    if (const InfluenceField* field = fieldIfPaid(test.a, kWithoutField); field != nullptr && wanted == Wanted::Answer)
      meeting = meetInField(*field, at, limit, test);
  if (meeting == Meeting::Unknown) meeting = meetAtOnce(at, limit, wanted, test, outcome.clearance);
  if (meeting == Meeting::Unknown) return searchTrees(at, test, lookahead, wanted);
  outcome.collides = meeting == Meeting::Meet;
  outcome.clearance = at.inWorld(outcome.clearance, test.a.unit);
  return outcome;
}

/// The same for a pair whose relative pose is known.
Outcome collideByHierarchy(const PosedPair& pair, const CollideOptions& options, double lookahead, Wanted wanted);

}  // namespace tricover::detail
