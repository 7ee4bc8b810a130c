// SPDX-License-Identifier: BSD-3-Clause
// Two hierarchies descended together. See simd_gaps.h for Lanes.
#pragma once

#include "hierarchy/simd_gaps.h"

namespace tricover::detail::simd {

/// A pair of boxes.
struct Visit {
  std::uint32_t a, b;
  float gap;
};

struct Visits;
/// Defined beside the portable lanes, so that the standard library is not compiled for AVX2.
void growVisits(Visits& visits);
void releaseVisits(const Visit* visits);

/// The pairs of boxes that are left to look at, deepest on top. Queries run on small stacks: six levels of full blocks
/// fit there, and what deeper trees have in addition goes to the heap.
struct Visits {
  static constexpr int kMostOfStep = kLanes * kLanes;  // a step takes one, adds at most 64, a level below
  static constexpr int kFew = 6 * (kMostOfStep - 1) + 1;
  static_assert(kFew * sizeof(Visit) < 5000);
  Visit few[kFew];
  Visit* all = few;
  int top = 0, room = kFew;

  [[gnu::always_inline]] Visits() {}
  Visits(const Visits&) = delete;
  Visits& operator=(const Visits&) = delete;
  [[gnu::always_inline]] ~Visits() {
    if (all != few) releaseVisits(all);
  }

  [[gnu::always_inline]] void add(std::uint32_t a, std::uint32_t b, float gap) { all[top++] = {a, b, gap}; }
  /// Makes room for what one step may add.
  [[gnu::always_inline]] void prepareStep() {
    if (room - top < kMostOfStep) growVisits(*this);
  }
};

/// Puts the deepest of the pairs from `first` on on top.
[[gnu::always_inline]] inline void raiseDeepest(Visits& visits, int first) {
  const int last = visits.top - 1;
  int deepest = last;
  for (int i = first; i < last; ++i) deepest = visits.all[i].gap < visits.all[deepest].gap ? i : deepest;
  if (deepest == last || last < first) return;
  const Visit raised = visits.all[deepest];
  visits.all[deepest] = visits.all[last];
  visits.all[last] = raised;
}

/// What the boxes of one step have in common.
struct Step {
  double in_a;      ///< the frame's scale in a's units
  float threshold;  ///< boxes with a gap beyond aren't entered; it includes the slack
  float slack;      ///< what a gap may be too large by
  float cap;        ///< no gap is proven beyond this
  bool known;       ///< false where floats overflow, the frame being so small beside the distance
};

[[gnu::always_inline]] inline Step stepOf(double in_a, double limit, float slack, float cap) {
  const float threshold = upwards(limit + slack);
  return {in_a, threshold, slack, cap, slack < 1e30f && threshold < cap};
}

/// A lower bound, in a's units, of the distance between what is in two boxes.
[[gnu::always_inline]] inline double provenGap(const Step& step, float gap) {
  return step.known ? (gap - step.slack) * step.in_a : 0;
}

template <class Lanes>
[[gnu::always_inline]] inline float least(Lanes lanes, float at_most) {
  float values[kLanes];
  lanes.store(values);
  for (int i = 0; i < kLanes; ++i) at_most = values[i] < at_most ? values[i] : at_most;
  return at_most;
}

/// A descent's goal: the first two edges that make a hit.
struct FindHit {
  static constexpr bool kNarrows = false;
  static constexpr float kSlacks = 1;

  const HitTest& test;
  double limit;
  DescentResult result;

  /// At the leaves. True ends the descent.
  [[gnu::always_inline]] bool operator()(double proven, EdgePosition edge_a, EdgePosition edge_b) {
    result.clearance = proven < result.clearance ? proven : result.clearance;
    if (proven > test.reach || !test.meet(test.context, edge_a, edge_b)) return false;
    result = {true, 0, edge_a, edge_b};
    return true;
  }

  /// Whether one of these spanned boxes and another one prove their chains to be within `accept`: the boxes' distance
  /// by their gap (diagonally it may be sqrt(2) times that), and from there to the chains.
  [[gnu::always_inline]] bool accepts(const Step& step, unsigned boxes, const float* gap, const float* across,
                                      float other_across) {
    if (!step.known) return false;
    for (; boxes != 0; boxes &= boxes - 1) {
      const int i = __builtin_ctz(boxes);
      const double between = (gap[i] > 0 ? gap[i] : 0) + 2.0 * step.slack;
      if (!((1.4143 * between + 2.0 * (across[i] + other_across)) * step.in_a <= test.accept)) continue;
      result = {true, 0, kNoEdge, kNoEdge};
      return true;
    }
    return false;
  }
  [[gnu::always_inline]] bool mayAccept() const { return test.accept >= 0; }

  [[gnu::always_inline]] bool wantsClearance() const { return test.wants_clearance; }
  /// What is left out is at least as far as the least gap of it.
  template <class Lanes>
  [[gnu::always_inline]] void leaveOut(Lanes left_out, const Step& step) {
    if (!test.wants_clearance) return;
    const double proven = step.known ? (least(left_out, step.cap) - step.slack) * step.in_a : 0;
    result.clearance = proven < result.clearance ? proven : result.clearance;
  }

  /// What a visit is kept with: the boxes' gap in their block's scale is enough to tell the deepest.
  [[gnu::always_inline]] static float keptGap(const Step&, float gap) { return gap; }
};

/// A descent's goal: to show a visitor, who may lower the limit, all pairs of edges within it.
struct ShowPairs {
  static constexpr bool kNarrows = true;
  static constexpr float kSlacks = 1.5f;  ///< of gaps along all axes

  const PairVisitor& visitor;
  double limit;

  [[gnu::always_inline]] bool operator()(double proven, EdgePosition edge_a, EdgePosition edge_b) {
    if (proven <= limit) limit = visitor.visit(visitor.context, proven, edge_a, edge_b);
    return limit < 0;
  }

  [[gnu::always_inline]] bool accepts(const Step&, unsigned, const float*, const float*, float) { return false; }
  [[gnu::always_inline]] static bool mayAccept() { return false; }
  [[gnu::always_inline]] static bool wantsClearance() { return false; }
  template <class Lanes>
  [[gnu::always_inline]] static void leaveOut(Lanes, const Step&) {}

  /// What it proves, rounded downwards (as the threshold is upwards), to be compared with a limit that has been lowered
  /// since.
  [[gnu::always_inline]] static float keptGap(const Step& step, float gap) { return downwards(provenGap(step, gap)); }

  /// Lowers the limit to what the boxes of one step prove: `upper` is the least of what two spanned boxes may be apart,
  /// as in FindHit::accepts(), but for the slack: twice the gap's, 1.4143 times as in a diagonal. It is computed in
  /// five float operations, which is less than 1 + 2^-18 makes up for.
  template <class Lanes>
  [[gnu::always_inline]] void narrow(Lanes upper, const Step& step) {
    if (visitor.narrow == nullptr) return;
    const float nearest = least(upper, 1e30f);
    if (!step.known || nearest >= 1e29f) return;
    const double proven = (nearest + 3.0 * step.slack) * step.in_a * (1 + 0x1p-18);
    if (proven < limit) limit = visitor.narrow(visitor.context, proven);
  }
};

/// The boxes that must be entered; the least gap of the others is kept.
template <class Lanes, class Goal>
[[gnu::always_inline]] inline unsigned entered(const Goal& goal, const Block& block, const Step& step, Lanes found,
                                               Lanes& left_out) {
  if (!step.known) return lanesOf(block);
  const Lanes threshold = Lanes::all(step.threshold);
  if (goal.wantsClearance()) left_out = smaller(left_out, whereAbove(found, threshold));
  return lanesOf(block) & ~above(found, threshold);
}

/// One item against the boxes that the other one is divided into. True if that ended the descent.
template <class Lanes, class Goal>
bool enterOne(const Descent& d, bool into_a, const Item& item, const Item& other, std::uint32_t visit_a,
              std::uint32_t visit_b, Visits& visits, Goal& goal) {
  const std::uint32_t index = item.child;
  const Block& block = into_a ? d.a.blocks[index] : d.b.blocks[index];
  const UnitMap map = into_a ? d.to_a : inverse(d.to_a);
  float slack, cap;
  const Box box = boxIn(block, other, into_a ? d.polygon_b : d.polygon_a, map, slack, cap);
  const double in_a = into_a ? block.scale : block.scale * d.to_a.scale;
  const Step step = stepOf(in_a, goal.limit / in_a, slack * Goal::kSlacks, cap);
  const Lanes found = gaps<Goal::kNarrows>(boxesOf<Lanes>(block), box);
  Lanes left_out = Lanes::all(1e30f);
  const unsigned near = entered(goal, block, step, found, left_out);
  goal.leaveOut(left_out, step);
  float gap[kLanes];
  found.store(gap);

  if (goal.mayAccept() && other.spanned && goal.accepts(step, near & block.spanned, gap, block.across, box.across))
    return true;
  if (block.leaf && other.leaf) {
    for (unsigned left = near; left != 0; left &= left - 1) {
      const int i = __builtin_ctz(left);
      const EdgePosition edge = block.child[i];
      if (goal(provenGap(step, gap[i]), into_a ? edge : other.child, into_a ? other.child : edge)) return true;
    }
    return false;
  }
  const int first = visits.top;
  for (unsigned i = 0; i < kLanes; ++i) {
    visits.add(into_a ? index * kLanes + i : visit_a, into_a ? visit_b : index * kLanes + i,
               Goal::keptGap(step, gap[i]));
    visits.top -= static_cast<int>(~near >> i & 1);
  }
  raiseDeepest(visits, first);
  return false;
}

/// The boxes of two blocks of about the same size: b's in the frame of a's.
template <class Lanes>
[[gnu::always_inline]] inline Step bringTogether(const UnitMap& map, const Block& a, const Block& b, double limit,
                                                 float slacks, BoxLanes& moved) {
  const double size = map.scale * b.scale * a.inverse;
  const double x = (map.mappedX(b.origin_x, b.origin_y) - a.origin_x) * a.inverse;
  const double y = (map.mappedY(b.origin_x, b.origin_y) - a.origin_y) * a.inverse;
  const double slack = map.rounding * (magnitude(x) + magnitude(y) + 4 * size + 4) + map.error * a.inverse;
  const float scale = static_cast<float>(size);
  const Lanes bx = Lanes::load(b.x) * scale, by = Lanes::load(b.y) * scale;
  const Lanes bux = Lanes::load(b.ux), buy = Lanes::load(b.uy);
  (turnedX(map, bx, by) + static_cast<float>(x)).store(moved.x);
  (turnedY(map, bx, by) + static_cast<float>(y)).store(moved.y);
  turnedX(map, bux, buy).store(moved.ux);
  turnedY(map, bux, buy).store(moved.uy);
  (Lanes::load(b.along) * scale).store(moved.along);
  (Lanes::load(b.across) * scale).store(moved.across);
  return stepOf(a.scale, limit * a.inverse, static_cast<float>(slack) * slacks, 1e30f);
}

/// A box of the block's own hierarchy.
[[gnu::always_inline]] inline Box boxIn(const Block& block, const Item& item) {
  return {static_cast<float>((item.x - block.origin_x) * block.inverse),
          static_cast<float>((item.y - block.origin_y) * block.inverse),
          static_cast<float>(item.ux),
          static_cast<float>(item.uy),
          static_cast<float>(item.along * block.inverse),
          static_cast<float>(item.across * block.inverse)};
}

/// Fills the gaps of a's boxes (columns) against those of b's (rows), and lowers the limit by what they prove.
template <class Lanes>
[[gnu::always_inline]] inline void narrowFirst(const Block& a, const Block& b, const Boxes<Lanes>& boxes,
                                               const BoxLanes& moved, const Step& step, unsigned rows,
                                               float (&gap)[kLanes][kLanes], ShowPairs& goal) {
  float spans[kLanes];
  for (unsigned i = 0; i < kLanes; ++i) spans[i] = (a.spanned >> i & 1) != 0 ? 2 * a.across[i] : 1e30f;
  const Lanes spans_a = Lanes::load(spans);
  Lanes upper = Lanes::all(1e30f);
  for (; rows != 0; rows &= rows - 1) {
    const unsigned j = static_cast<unsigned>(__builtin_ctz(rows));
    const Box box = boxAt(moved, j);
    const Lanes found = gaps<true>(boxes, box);
    found.store(gap[j]);
    if ((b.spanned >> j & 1) != 0)
      upper = smaller(upper, larger(found, Lanes::all(0)) * 1.4143f + spans_a + 2 * box.across);
  }
  goal.narrow(upper, step);
}

/// A pair of lanes; none at first.
struct LanePair {
  unsigned i = kLanes, j = kLanes;
};

/// The least of the gaps that are to be entered.
template <class Lanes>
[[gnu::always_inline]] inline LanePair nearestPair(const Block& a, const Step& step, unsigned rows,
                                                   const float (&gap)[kLanes][kLanes], const ShowPairs& goal) {
  LanePair nearest;
  Lanes unused = Lanes::all(0);
  float least = 0;
  for (; rows != 0; rows &= rows - 1) {
    const unsigned j = static_cast<unsigned>(__builtin_ctz(rows));
    for (unsigned left = entered(goal, a, step, Lanes::load(gap[j]), unused); left != 0; left &= left - 1) {
      const unsigned i = static_cast<unsigned>(__builtin_ctz(left));
      if (nearest.i != kLanes && !(gap[j][i] < least)) continue;
      least = gap[j][i];
      nearest = {i, j};
    }
  }
  return nearest;
}

/// Two items that are both divided. True if that ended the descent.
template <class Lanes, class Goal>
[[gnu::always_inline]] inline bool enterBoth(const Descent& d, const Item& item_a, const Item& item_b, Visits& visits,
                                             Goal& goal) {
  const Block &a = d.a.blocks[item_a.child], &b = d.b.blocks[item_b.child];
  BoxLanes moved;
  Step step = bringTogether<Lanes>(d.to_a, a, b, goal.limit, Goal::kSlacks, moved);
  const bool leaves = a.leaf && b.leaf;
  // First the whole of a against b's boxes.
  Lanes left_out = Lanes::all(1e30f);
  const Lanes from_whole = gaps<Goal::kNarrows>(boxesOf<Lanes>(moved), boxIn(a, item_a));
  const unsigned near_b = entered(goal, b, step, from_whole, left_out);
  const Boxes<Lanes> boxes = boxesOf<Lanes>(a);
  float gap[kLanes][kLanes];
  LanePair shown;
  if constexpr (Goal::kNarrows) {
    narrowFirst(a, b, boxes, moved, step, near_b, gap, goal);
    step = stepOf(a.scale, goal.limit * a.inverse, step.slack, step.cap);
    // Of edges, the nearest: it may spare the others.
    if (leaves) shown = nearestPair<Lanes>(a, step, near_b, gap, goal);
    if (shown.i != kLanes && goal(provenGap(step, gap[shown.j][shown.i]), a.child[shown.i], b.child[shown.j]))
      return true;
  }
  const int first = visits.top;
  for (unsigned left = near_b; left != 0; left &= left - 1) {
    const unsigned j = static_cast<unsigned>(__builtin_ctz(left));
    const Box box = boxAt(moved, j);
    if constexpr (!Goal::kNarrows) gaps<false>(boxes, box).store(gap[j]);
    unsigned near = entered(goal, a, step, Lanes::load(gap[j]), left_out);
    if (goal.mayAccept() && (b.spanned >> j & 1) != 0 &&
        goal.accepts(step, near & a.spanned, gap[j], a.across, box.across))
      return true;
    if (leaves) {
      if (j == shown.j) near &= ~(1u << shown.i);
      for (; near != 0; near &= near - 1) {
        const int i = __builtin_ctz(near);
        if (goal(provenGap(step, gap[j][i]), a.child[i], b.child[j])) return true;
      }
      continue;
    }
    for (; near != 0; near &= near - 1) {
      const unsigned i = static_cast<unsigned>(__builtin_ctz(near));
      visits.add(item_a.child * kLanes + i, item_b.child * kLanes + j, Goal::keptGap(step, gap[j][i]));
    }
  }
  goal.leaveOut(left_out, step);
  raiseDeepest(visits, first);
  return false;
}

/// From both roots on. True if the goal ended it.
template <class Lanes, class Goal>
[[gnu::always_inline]] inline bool descendBoth(const Descent& d, Goal& goal) {
  Visits visits;
  visits.add(kRoot, kRoot, -1e30f);
  const EdgePosition edge_a = d.degenerate ? d.polygon_a.degenerate_edge : kNoEdge;
  const EdgePosition edge_b = d.degenerate ? d.polygon_b.degenerate_edge : kNoEdge;
  assert(edge_a == kNoEdge || edge_b == kNoEdge);
  while (visits.top > 0) {
    const auto [visit_a, visit_b, gap] = visits.all[--visits.top];
    if (Goal::kNarrows && gap > goal.limit) continue;
    visits.prepareStep();
    const Item a = itemAt(d.a, visit_a, edge_a), b = itemAt(d.b, visit_b, edge_b);
    // What is so much smaller stays whole: divided, each part of it would go all the way down the larger one. Beyond
    // 32 floats couldn't tell its boxes apart in the larger one's frame, either.
    constexpr double kAlike = 4;
    const double size_a = a.along + a.across, size_b = (b.along + b.across) * d.to_a.scale;
    const bool both = !a.leaf && !b.leaf && size_a < kAlike * size_b && size_b < kAlike * size_a;
    const bool into_a = b.leaf || (!a.leaf && size_a >= size_b);
    if (both ? enterBoth<Lanes>(d, a, b, visits, goal)
             : enterOne<Lanes>(d, into_a, into_a ? a : b, into_a ? b : a, visit_a, visit_b, visits, goal))
      return true;
  }
  return false;
}

template <class Lanes>
DescentResult findHit(const Descent& d, const HitTest& test) {
  FindHit goal{test, d.limit, {false, 1e300, kNoEdge, kNoEdge}};
  if (descendBoth<Lanes>(d, goal)) return goal.result;
  return {false, goal.result.clearance > 0 ? goal.result.clearance : 0, kNoEdge, kNoEdge};
}

template <class Lanes>
void showPairs(const Descent& d, const PairVisitor& visitor) {
  ShowPairs goal{visitor, d.limit};
  descendBoth<Lanes>(d, goal);
}

}  // namespace tricover::detail::simd
