// SPDX-License-Identifier: BSD-3-Clause
// Two hierarchies, of which the smaller one stays whole where it is among many rings. See simd_gaps.h for Lanes.
#pragma once

#include "hierarchy/simd_descent.h"

namespace tricover::detail::simd {

/// All of a b that staysWhole() in a box along a's axes, in a's units: its centre, and half its extents.
struct WholeB {
  double x, y, half_x, half_y;
};

[[gnu::always_inline]] inline WholeB wholeB(const Descent& d) {
  const UnitMap& map = d.to_a;
  const Box& b = d.b.root;
  const double ux = magnitude(map.r00 * b.ux + map.r01 * b.uy), uy = magnitude(map.r10 * b.ux + map.r11 * b.uy);
  return {map.scale * (map.r00 * b.x + map.r01 * b.y) + map.tx, map.scale * (map.r10 * b.x + map.r11 * b.y) + map.ty,
          map.scale * (b.along * ux + b.across * uy), map.scale * (b.along * uy + b.across * ux)};
}

/// A block's boxes that it may come within the limit of, by their extents along a's axes, which are no more than others
/// along theirs: rounded as kGapRounding counts. `gap` is what is kept of each (Goal::keptGap()), with a diagonal as in
/// gaps() if that matters.
template <class Lanes, class Goal>
[[gnu::always_inline]] inline unsigned nearWhole(const Descent& d, const WholeB& b, const Block& block,
                                                 const Goal& goal, float (&gap)[kLanes]) {
  const double x = (b.x - block.origin_x) * block.inverse, y = (b.y - block.origin_y) * block.inverse;
  const double half_x = b.half_x * block.inverse, half_y = b.half_y * block.inverse;
  const double slack = d.rounding * (magnitude(x) + magnitude(y) + half_x + half_y + 4) + d.to_a.error * block.inverse;
  const Step step = stepOf(block.scale, goal.limit * block.inverse, static_cast<float>(slack) * Goal::kSlacks, 1e30f);
  const Boxes<Lanes> box = boxesOf<Lanes>(block);
  const Lanes c = absolute(box.ux), s = absolute(box.uy);
  const Lanes gap_x = absolute(box.x - static_cast<float>(x)) - (box.along * c + box.across * s) -
                      Lanes::all(static_cast<float>(half_x));
  const Lanes gap_y = absolute(box.y - static_cast<float>(y)) - (box.along * s + box.across * c) -
                      Lanes::all(static_cast<float>(half_y));
  Lanes found = larger(gap_x, gap_y), unused = found;
  if constexpr (Goal::kNarrows) {
    found = larger(found, (gap_x + gap_y) * 0.70710678f);
    if (step.known)
      ((found - step.slack) * (block.scale * (1 - 0x1p-20f))).store(gap);
    else
      Lanes::all(0).store(gap);
  }
  return entered(goal, block, step, found, unused);
}

/// A leaf's edges that may come within the limit of b's box.
template <class Lanes>
[[gnu::always_inline]] inline unsigned edgesNear(const Descent& d, const Item& b, const Block& leaf, double limit) {
  const Query query = queryFor(b, d.polygon_b, d.to_a, leaf, d.rounding);
  const Step step = stepOf(leaf.scale, limit * leaf.inverse, query.slack, query.cap);
  if (!step.known) return lanesOf(leaf);
  return lanesOf(leaf) & ~above(gaps<false>(boxesOf<Lanes>(leaf), query), Lanes::all(step.threshold));
}

/// A ring's first edge doesn't follow the one in the lane before.
[[gnu::always_inline]] inline bool beginsRing(const Block& leaf, int i) {
  return i == 0 || leaf.child[i - 1] + 1 != leaf.child[i];
}

/// Of a b that staysWhole(). Its box tells which rings may begin in b, too.
template <class Lanes>
void findHitAmongRings(const Descent& d, FindHit& goal) {
  const Item b = itemAt(d.b, kRoot, PolygonData::kNotDegenerate);
  const WholeB whole_b = wholeB(d);
  const auto near = [&](const Block& block, float(&at)[kLanes]) __attribute__((always_inline)) {
    return block.leaf ? edgesNear<Lanes>(d, b, block, goal.limit) : nearWhole<Lanes>(d, whole_b, block, goal, at);
  };
  const auto show = [&](const Block& block, unsigned lanes, const float*) __attribute__((always_inline)) {
    const auto first = static_cast<std::uint32_t>(&block - d.a.blocks.data()) * kLanes;
    for (; lanes != 0; lanes &= lanes - 1) {
      const int i = __builtin_ctz(lanes);
      const std::uint32_t edge = block.child[i];
      if (beginsRing(block, i) && goal.test.holds(goal.test.context, edge))
        return goal.result = {true, 0, edge, -1}, false;
      if (descendBoth<Lanes>(d, goal, first + static_cast<std::uint32_t>(i))) return false;
    }
    return true;
  };
  descendOne<false>(
      d.a, [](float) { return true; }, near, show);
}

template <class Lanes>
DescentResult findHit(const Descent& d, const HitTest& test) {
  FindHit goal{test, d.limit, {false, 1e300, -1, -1}};
  if (test.holds != nullptr) return findHitAmongRings<Lanes>(d, goal), goal.result;
  if (descendBoth<Lanes>(d, goal)) return goal.result;
  return {false, goal.result.clearance > 0 ? goal.result.clearance : 0, -1, -1};
}

/// The same, the nearest box of each block first. Which of the others are near enough is seen once that has lowered the
/// limit.
template <class Lanes>
void showPairsAmongRings(const Descent& d, ShowPairs& goal) {
  struct Entered {
    const Block* block;
    unsigned left;
    float gap[kLanes];
  } entered[kMaxDepth];
  const Item b = itemAt(d.b, kRoot, PolygonData::kNotDegenerate);
  const WholeB whole_b = wholeB(d);
  const Block* const all = d.a.blocks.data();
  const auto holdsRingOf = [&](const Block& leaf) __attribute__((always_inline)) {
    for (unsigned lanes = edgesNear<Lanes>(d, b, leaf, 0); lanes != 0; lanes &= lanes - 1) {
      const int i = __builtin_ctz(lanes);
      if (beginsRing(leaf, i) && goal.visitor.holds(goal.visitor.context, leaf.child[i])) return true;
    }
    return false;
  };
  int count = 0;
  const auto enter = [&](const Block& block) __attribute__((always_inline)) {
    Entered& here = entered[count++];
    here.block = &block;
    here.left = nearWhole<Lanes>(d, whole_b, block, goal, here.gap);
  };
  enter(all[0]);
  while (count > 0) {
    Entered& here = entered[count - 1];
    here.left &= ~above(Lanes::load(here.gap), Lanes::all(upwards(goal.limit)));
    if (here.left == 0) {
      --count;
      continue;
    }
    int nearest = __builtin_ctz(here.left);
    float least = here.gap[nearest];
    for (unsigned left = here.left & (here.left - 1); left != 0; left &= left - 1) {
      const int i = __builtin_ctz(left);
      const bool is_nearer = here.gap[i] < least;
      nearest = is_nearer ? i : nearest;
      least = is_nearer ? here.gap[i] : least;
    }
    here.left &= ~(1u << nearest);
    const Block& child = all[here.block->child[nearest]];
    if (!child.leaf) {
      enter(child);
      continue;
    }
    if (!(least > 0) && goal.visitor.holds != nullptr && holdsRingOf(child)) return;
    if (descendBoth<Lanes>(d, goal, static_cast<std::uint32_t>((here.block - all) * kLanes + nearest))) return;
  }
}

template <class Lanes>
void showPairs(const Descent& d, const PairVisitor& visitor) {
  ShowPairs goal{visitor, d.limit};
  if (staysWhole(d))
    showPairsAmongRings<Lanes>(d, goal);
  else
    descendBoth<Lanes>(d, goal);
}

}  // namespace tricover::detail::simd
