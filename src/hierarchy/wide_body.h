// SPDX-License-Identifier: BSD-3-Clause
// No include guard: wide.cpp includes this once an instruction set, in a namespace of its own, with TRICOVER_TARGET the
// functions' attribute and TRICOVER_VECTOR the bytes of a native vector. So it is for what it includes: eight floats
// side by side, and the ways that need no tree.

#include "hierarchy/wide_lanes.h"

/// A box of one hierarchy, in its units.
struct Item {
  double x, y, ux, uy, along, across;
  std::uint32_t child;
  bool leaf, spanned;
};

constexpr std::uint32_t kRoot = 0xffffffff;

TRICOVER_INLINE Item itemAt(const Hierarchy& hierarchy, std::uint32_t index) {
  if (index == kRoot) {
    const Box& box = hierarchy.root;
    return {box.x, box.y, box.ux, box.uy, box.along, box.across, 0, false, hierarchy.root_spanned};
  }
  const Block& block = hierarchy.blocks[index / kLanes];
  const unsigned lane = index % kLanes;
  const double scale = block.scale;
  return {block.origin_x + block.x[lane] * scale,
          block.origin_y + block.y[lane] * scale,
          block.ux[lane],
          block.uy[lane],
          block.along[lane] * scale,
          block.across[lane] * scale,
          block.child[lane],
          block.leaf,
          (block.spanned >> lane & 1) != 0};
}

/// A box in a block's scale, from its origin.
struct Query {
  float x, y, ux, uy, along, across;
  float slack;  ///< what a gap may be too large by
  float cap;    ///< no gap is proven beyond this
};

constexpr double kLong = 512, kKept = 64;

/// A long edge beside a small block: only its part around the block counts, which floats can tell from the block; and
/// the edge itself is known better than the float box around it. Returns the distance up to which that part stands for
/// the whole.
TRICOVER_INLINE double clip(const Item& item, const PolygonData& polygon, const UnitMap& map, const Block& block,
                            double& x, double& y, double& ux, double& uy, double& along, double& across) {
  if (item.leaf) {
    const Vec2 v = polygon.inUnits(polygon.path[item.child]), w = polygon.inUnits(polygon.path[item.child + 1]);
    const Vec2 half = 0.5 * (w - v), middle = v + half;
    const double size = map.scale * block.inverse, length = half.norm();
    x = (map.scale * (map.r00 * middle.x() + map.r01 * middle.y()) + map.tx - block.origin_x) * block.inverse;
    y = (map.scale * (map.r10 * middle.x() + map.r11 * middle.y()) + map.ty - block.origin_y) * block.inverse;
    ux = (map.r00 * half.x() + map.r01 * half.y()) / length;
    uy = (map.r10 * half.x() + map.r11 * half.y()) / length;
    along = length * size;
    across = 0;
  }
  const double at = -(x * ux + y * uy) / (ux * ux + uy * uy);
  double low = at - kKept, high = at + kKept;
  low = low < -along ? -along : low > along ? along : low;
  high = high < -along ? -along : high > along ? along : high;
  const double middle = 0.5 * (low + high);
  x += middle * ux;
  y += middle * uy;
  along = 0.5 * (high - low);
  return kKept - 4;
}

/// Slack. In the block's scale its boxes are within 1 of the origin in either coordinate and no larger than 1. Rounding
/// the query to floats, and 20 float operations on values below |x| + |y| + along + across + 4, err by less than 32
/// 2^-24 of that: Descent::rounding is 2^-19 and, because a box is taken for a rectangle after a map that is rigid only
/// within `defect`, 8 defects.
TRICOVER_INLINE Query queryFor(const Item& item, const PolygonData& polygon, const UnitMap& map, const Block& block,
                               double rounding) {
  double x = (map.scale * (map.r00 * item.x + map.r01 * item.y) + map.tx - block.origin_x) * block.inverse;
  double y = (map.scale * (map.r10 * item.x + map.r11 * item.y) + map.ty - block.origin_y) * block.inverse;
  double ux = map.r00 * item.ux + map.r01 * item.uy, uy = map.r10 * item.ux + map.r11 * item.uy;
  const double size = map.scale * block.inverse;
  double along = item.along * size;
  double across = item.across * size;
  double cap = 1e30;
  if (along > kLong) cap = clip(item, polygon, map, block, x, y, ux, uy, along, across);
  const double slack = rounding * (magnitude(x) + magnitude(y) + along + across + 4) + map.error * block.inverse;
  return {static_cast<float>(x),     static_cast<float>(y),      static_cast<float>(ux),    static_cast<float>(uy),
          static_cast<float>(along), static_cast<float>(across), static_cast<float>(slack), static_cast<float>(cap)};
}

/// Largest gap, over the four axes of the query and each box, between their projections (separating axes): a lower
/// bound of their distance but for the slack; positive only if they are apart. With kDiagonals the axes between those
/// count, too, which finds 0.92 of the distance at least (gaps along two axes at right angles are taken together there,
/// so that the error is sqrt(2) times theirs), and so does the line of the centres: along the sides of two round
/// outlines, that are beyond each other's nearest points, only that one grows with the distance. Its products are
/// rounded four times and divided by what they have in common.
template <bool kDiagonals>
TRICOVER_INLINE Lanes gaps(Lanes x, Lanes y, Lanes ux, Lanes uy, Lanes along, Lanes across, const Query& q) {
  const Lanes dx = x - q.x, dy = y - q.y;
  const Lanes c = absolute(ux * q.ux + uy * q.uy), s = absolute(ux * q.uy - uy * q.ux);
  const Lanes along_apart = absolute(dx * q.ux + dy * q.uy), across_apart = absolute(dy * q.ux - dx * q.uy);
  const Lanes box_along_apart = absolute(dx * ux + dy * uy), box_across_apart = absolute(dy * ux - dx * uy);
  const Lanes along_query = along_apart - (along * c + across * s + q.along);
  const Lanes across_query = across_apart - (along * s + across * c + q.across);
  const Lanes along_box = box_along_apart - (along + c * q.along + s * q.across);
  const Lanes across_box = box_across_apart - (across + s * q.along + c * q.across);
  const Lanes largest = larger(larger(along_query, across_query), larger(along_box, across_box));
  if (!kDiagonals) return largest;
  constexpr float kHalf = 0.70710678f;  // at most the root of 1/2 but for rounding
  const Lanes diagonal = larger(along_query + across_query, along_box + across_box) * kHalf;
  const Lanes square = dx * dx + dy * dy, extents = along * box_along_apart + across * box_across_apart +
                                                    (along_apart * q.along + across_apart * q.across);
  const Lanes between = (square - extents) / root(square);  // NaN where the centres are the same, which larger drops
  return larger(between, larger(largest, diagonal));
}

template <bool kDiagonals>
TRICOVER_INLINE Lanes gaps(const Block& block, const Query& q) {
  return gaps<kDiagonals>(load(block.x), load(block.y), load(block.ux), load(block.uy), load(block.along),
                          load(block.across), q);
}

/// The pairs of boxes that are left to look at, deepest on top.
struct Visits {
  static constexpr int kMost = kLanes * kLanes * kMaxDepth + 1;  // a step takes one, adds at most 64, a level below
  std::uint32_t a[kMost], b[kMost];
  float gap[kMost];
  int top;
};

/// Puts the deepest of the pairs from `first` on on top.
TRICOVER_INLINE void raiseDeepest(Visits& visits, int first) {
  const int last = visits.top - 1;
  int deepest = last;
  for (int i = first; i < last; ++i) deepest = visits.gap[i] < visits.gap[deepest] ? i : deepest;
  if (deepest == last || last < first) return;
  const std::uint32_t a = visits.a[deepest], b = visits.b[deepest];
  visits.a[deepest] = visits.a[last];
  visits.b[deepest] = visits.b[last];
  visits.gap[deepest] = visits.gap[last];
  visits.a[last] = a;
  visits.b[last] = b;
}

/// What the boxes of one step have in common.
struct Step {
  double in_a;      ///< the frame's scale in a's units
  float threshold;  ///< boxes with a gap beyond aren't entered; it includes the slack
  float slack;      ///< what a gap may be too large by
  float cap;        ///< no gap is proven beyond this
  bool known;       ///< false where floats overflow, the frame being so small beside the distance
};

TRICOVER_INLINE Step stepOf(double in_a, double limit, float slack, float cap) {
  const float threshold = static_cast<float>(limit + slack) * (1 + 0x1p-20f);
  return {in_a, threshold, slack, cap, slack < 1e30f && threshold < cap};
}

/// The boxes that must be entered; the least gap of the others is kept.
TRICOVER_INLINE unsigned entered(const Descent& d, const Block& block, const Step& step, Lanes found, Lanes& least) {
  const unsigned used = (1u << block.count) - 1;
  if (!step.known) return used;
  const Lanes threshold = all(step.threshold);
  if (d.wants_clearance) least = smaller(least, whereAbove(found, threshold));
  return used & ~above(found, threshold);
}

/// Whether spanned boxes prove their chains to be within `accept`: the boxes' distance by their gap (diagonally it may
/// be sqrt(2) times that), and from there to the chains.
TRICOVER_INLINE bool accepts(const Descent& d, const Step& step, float gap, float across, float other_across) {
  const double between = (gap > 0 ? gap : 0) + 2.0 * step.slack;
  return step.known && (1.4143 * between + 2.0 * (across + other_across)) * step.in_a <= d.accept;
}

/// What a descent has found so far.
struct Findings {
  DescentResult hit;
  double clearance;
};

TRICOVER_INLINE bool accepted(Findings& findings) {
  findings.hit = {true, 0, -1, -1};
  return true;
}

/// A lower bound, in a's units, of the distance between what is in two boxes.
TRICOVER_INLINE double provenGap(const Step& step, float gap) {
  return step.known ? (gap - step.slack) * step.in_a : 0;
}

/// Asks whether two edges meet, unless their boxes' gap proves already that they don't.
struct MeetEdges : Findings {
  static constexpr bool kNarrows = false;
  static constexpr float kSlacks = 1;
  TRICOVER_INLINE double limitOf(const Descent& d) const { return d.limit; }

  TRICOVER_INLINE bool operator()(const Descent& d, double proven, std::uint32_t edge_a, std::uint32_t edge_b) {
    clearance = proven < clearance ? proven : clearance;
    if (proven > d.reach || !edgesWithin(d.pair, edge_a, edge_b, d.margin, d.tolerance)) return false;
    hit = {true, 0, edge_a, edge_b};
    return true;
  }
};

/// Shows them to a visitor, who may lower the limit.
struct ShowEdges : Findings {
  static constexpr bool kNarrows = true;
  static constexpr float kSlacks = 1.5f;  ///< of gaps with diagonals
  PairVisitor visitor;
  double limit;  ///< in a's units: boxes beyond aren't entered
  TRICOVER_INLINE double limitOf(const Descent&) const { return limit; }

  TRICOVER_INLINE bool operator()(const Descent&, double proven, std::uint32_t edge_a, std::uint32_t edge_b) {
    if (proven <= limit) limit = visitor.visit(visitor.context, proven, edge_a, edge_b);
    return limit < 0;
  }
};

TRICOVER_INLINE void keepLeast(const Descent& d, Lanes least, const Step& step, Findings& findings) {
  if (!d.wants_clearance) return;
  if (!step.known) {
    findings.clearance = 0;
    return;
  }
  float values[kLanes];
  store(values, least);
  float lowest = step.cap;
  for (int i = 0; i < kLanes; ++i) lowest = values[i] < lowest ? values[i] : lowest;
  const double proven = (lowest - step.slack) * step.in_a;
  findings.clearance = proven < findings.clearance ? proven : findings.clearance;
}

/// Lowers the limit to what the boxes of one step prove: `upper` is the least of what two spanned boxes may be apart,
/// as in accepts(), but for the slack.
TRICOVER_INLINE void narrow(Lanes upper, const Step& step, ShowEdges& show) {
  float values[kLanes], least = 1e30f;
  store(values, upper);
  for (int i = 0; i < kLanes; ++i) least = values[i] < least ? values[i] : least;
  if (!step.known || least >= 1e29f) return;
  const double proven = (least + 3.0 * step.slack) * step.in_a * (1 + 0x1p-18);
  if (proven < show.limit) show.limit = show.visitor.narrow(show.visitor.context, proven);
}

/// What a visit is kept with: the boxes' gap in their block's scale, which is enough to tell the deepest, or what it
/// proves, to be compared with a limit that has been lowered since.
template <typename OnPair>
TRICOVER_INLINE float keptGap(const Step& step, float gap) {
  return OnPair::kNarrows ? static_cast<float>(provenGap(step, gap)) * (1 - 0x1p-20f) : gap;
}

/// One item against the boxes that the other one is divided into. True if that ended the descent.
template <typename OnPair>
TRICOVER_TARGET bool enterOne(const Descent& d, bool into_a, const Item& item, const Item& other, std::uint32_t visit_a,
                              std::uint32_t visit_b, Visits& visits, OnPair& on_pair) {
  const std::uint32_t index = item.child;
  const Block& block = into_a ? d.a.blocks[index] : d.b.blocks[index];
  const UnitMap map = into_a ? d.to_a : inverse(d.to_a);
  const Query query = queryFor(other, into_a ? d.pair.b : d.pair.a, map, block, d.rounding);
  const double in_a = into_a ? block.scale : block.scale * d.to_a.scale;
  const Step step = stepOf(in_a, on_pair.limitOf(d) / in_a, query.slack * OnPair::kSlacks, query.cap);
  const Lanes found = gaps<OnPair::kNarrows>(block, query);
  Lanes least = all(1e30f);
  const unsigned near = entered(d, block, step, found, least);
  keepLeast(d, least, step, on_pair);
  float gap[kLanes];
  store(gap, found);

  if (d.accept >= 0 && other.spanned)
    for (unsigned left = near & block.spanned; left != 0; left &= left - 1) {
      const int i = __builtin_ctz(left);
      if (accepts(d, step, gap[i], block.across[i], query.across)) return accepted(on_pair);
    }
  if (block.leaf && other.leaf) {
    for (unsigned left = near; left != 0; left &= left - 1) {
      const int i = __builtin_ctz(left);
      const std::uint32_t edge = block.child[i];
      if (on_pair(d, provenGap(step, gap[i]), into_a ? edge : other.child, into_a ? other.child : edge)) return true;
    }
    return false;
  }
  const int first = visits.top;
  for (unsigned i = 0; i < kLanes; ++i) {
    visits.a[visits.top] = into_a ? index * kLanes + i : visit_a;
    visits.b[visits.top] = into_a ? visit_b : index * kLanes + i;
    visits.gap[visits.top] = keptGap<OnPair>(step, gap[i]);
    visits.top += static_cast<int>(near >> i & 1);
  }
  raiseDeepest(visits, first);
  return false;
}

/// The boxes of two blocks of about the same size, in the frame of a's.
struct Together {
  Step step;
  Query whole;             ///< all of a
  float moved[6][kLanes];  ///< b's boxes
};

TRICOVER_INLINE Query movedBox(const Together& t, unsigned j) {
  return {t.moved[0][j], t.moved[1][j], t.moved[2][j], t.moved[3][j], t.moved[4][j], t.moved[5][j], 0, 0};
}

TRICOVER_INLINE void bringTogether(const Descent& d, const Item& item_a, const Block& a, const Block& b, double limit,
                                   float slacks, Together& t) {
  const UnitMap& map = d.to_a;
  const double size = map.scale * b.scale * a.inverse;
  const double x = (map.scale * (map.r00 * b.origin_x + map.r01 * b.origin_y) + map.tx - a.origin_x) * a.inverse;
  const double y = (map.scale * (map.r10 * b.origin_x + map.r11 * b.origin_y) + map.ty - a.origin_y) * a.inverse;
  const double slack = d.rounding * (magnitude(x) + magnitude(y) + 4 * size + 4) + map.error * a.inverse;
  t.step = stepOf(a.scale, limit * a.inverse, static_cast<float>(slack) * slacks, 1e30f);

  const float r00 = static_cast<float>(map.r00), r01 = static_cast<float>(map.r01);
  const float r10 = static_cast<float>(map.r10), r11 = static_cast<float>(map.r11);
  const float scale = static_cast<float>(size);
  const Lanes bx = load(b.x) * scale, by = load(b.y) * scale, bux = load(b.ux), buy = load(b.uy);
  store(t.moved[0], bx * r00 + by * r01 + static_cast<float>(x));
  store(t.moved[1], bx * r10 + by * r11 + static_cast<float>(y));
  store(t.moved[2], bux * r00 + buy * r01);
  store(t.moved[3], bux * r10 + buy * r11);
  store(t.moved[4], load(b.along) * scale);
  store(t.moved[5], load(b.across) * scale);

  t.whole = {static_cast<float>((item_a.x - a.origin_x) * a.inverse),
             static_cast<float>((item_a.y - a.origin_y) * a.inverse),
             static_cast<float>(item_a.ux),
             static_cast<float>(item_a.uy),
             static_cast<float>(item_a.along * a.inverse),
             static_cast<float>(item_a.across * a.inverse),
             0,
             0};
}

/// True if that ended the descent.
TRICOVER_TARGET bool enterBoth(const Descent& d, const Item& item_a, const Item& item_b, Visits& visits,
                               MeetEdges& on_pair) {
  const Block &a = d.a.blocks[item_a.child], &b = d.b.blocks[item_b.child];
  Together t;
  bringTogether(d, item_a, a, b, d.limit, 1, t);
  const Step step = t.step;
  // First the whole of a against b's boxes.
  Lanes least = all(1e30f);
  const Lanes from_whole = gaps<false>(load(t.moved[0]), load(t.moved[1]), load(t.moved[2]), load(t.moved[3]),
                                       load(t.moved[4]), load(t.moved[5]), t.whole);
  const Lanes ax = load(a.x), ay = load(a.y), aux = load(a.ux), auy = load(a.uy), a_along = load(a.along),
              a_across = load(a.across);
  const int first = visits.top;
  for (unsigned left = entered(d, b, step, from_whole, least); left != 0; left &= left - 1) {
    const unsigned j = static_cast<unsigned>(__builtin_ctz(left));
    const Query query = movedBox(t, j);
    const Lanes found = gaps<false>(ax, ay, aux, auy, a_along, a_across, query);
    const unsigned near = entered(d, a, step, found, least);
    float gap[kLanes];
    store(gap, found);
    if (d.accept >= 0 && (b.spanned >> j & 1) != 0)
      for (unsigned i_left = near & a.spanned; i_left != 0; i_left &= i_left - 1) {
        const int i = __builtin_ctz(i_left);
        if (accepts(d, step, gap[i], a.across[i], query.across)) return accepted(on_pair);
      }
    if (a.leaf && b.leaf) {
      for (unsigned i_left = near; i_left != 0; i_left &= i_left - 1) {
        const int i = __builtin_ctz(i_left);
        if (on_pair(d, provenGap(step, gap[i]), a.child[i], b.child[j])) return true;
      }
      continue;
    }
    for (unsigned i = 0; i < kLanes; ++i) {
      visits.a[visits.top] = item_a.child * kLanes + i;
      visits.b[visits.top] = item_b.child * kLanes + j;
      visits.gap[visits.top] = gap[i];
      visits.top += static_cast<int>(near >> i & 1);
    }
  }
  keepLeast(d, least, step, on_pair);
  raiseDeepest(visits, first);
  return false;
}

/// The same, first lowering the limit to what all boxes together prove; true if a visitor ended the descent.
TRICOVER_TARGET bool enterBoth(const Descent& d, const Item& item_a, const Item& item_b, Visits& visits,
                               ShowEdges& on_pair) {
  const Block &a = d.a.blocks[item_a.child], &b = d.b.blocks[item_b.child];
  Together t;
  bringTogether(d, item_a, a, b, on_pair.limit, ShowEdges::kSlacks, t);
  const Step step = t.step;
  Lanes least = all(1e30f);
  const Lanes from_whole = gaps<true>(load(t.moved[0]), load(t.moved[1]), load(t.moved[2]), load(t.moved[3]),
                                      load(t.moved[4]), load(t.moved[5]), t.whole);
  const Lanes ax = load(a.x), ay = load(a.y), aux = load(a.ux), auy = load(a.uy), a_along = load(a.along),
              a_across = load(a.across);
  const int first = visits.top;
  const unsigned near_b = entered(d, b, step, from_whole, least);
  float gap[kLanes][kLanes], spans[kLanes];
  for (unsigned i = 0; i < kLanes; ++i) spans[i] = (a.spanned >> i & 1) != 0 ? 2 * a.across[i] : 1e30f;
  const Lanes spans_a = load(spans);
  Lanes upper = all(1e30f);
  for (unsigned left = near_b; left != 0; left &= left - 1) {
    const unsigned j = static_cast<unsigned>(__builtin_ctz(left));
    const Query query = movedBox(t, j);
    const Lanes found = gaps<true>(ax, ay, aux, auy, a_along, a_across, query);
    store(gap[j], found);
    if ((b.spanned >> j & 1) != 0) upper = smaller(upper, larger(found, all(0)) * 1.4143f + spans_a + 2 * query.across);
  }
  if (on_pair.visitor.narrow != nullptr) narrow(upper, step, on_pair);
  const Step narrowed = stepOf(a.scale, on_pair.limit * a.inverse, step.slack, 1e30f);
  unsigned near[kLanes];
  unsigned nearest_i = 0, nearest_j = 0;
  float nearest = 0;
  bool any = false;
  for (unsigned left = near_b; left != 0; left &= left - 1) {
    const unsigned j = static_cast<unsigned>(__builtin_ctz(left));
    near[j] = entered(d, a, narrowed, load(gap[j]), least);
    for (unsigned i_left = near[j]; i_left != 0; i_left &= i_left - 1) {
      const unsigned i = static_cast<unsigned>(__builtin_ctz(i_left));
      if (any && !(gap[j][i] < nearest)) continue;
      any = true;
      nearest = gap[j][i];
      nearest_i = i;
      nearest_j = j;
    }
  }
  if (!any) return false;
  if (a.leaf && b.leaf) {
    // The nearest first: it may spare the others.
    if (on_pair(d, provenGap(step, nearest), a.child[nearest_i], b.child[nearest_j])) return true;
    near[nearest_j] &= ~(1u << nearest_i);
  }
  for (unsigned left = near_b; left != 0; left &= left - 1) {
    const unsigned j = static_cast<unsigned>(__builtin_ctz(left));
    for (unsigned i_left = near[j]; i_left != 0; i_left &= i_left - 1) {
      const unsigned i = static_cast<unsigned>(__builtin_ctz(i_left));
      if (a.leaf && b.leaf) {
        if (on_pair(d, provenGap(step, gap[j][i]), a.child[i], b.child[j])) return true;
        continue;
      }
      visits.a[visits.top] = item_a.child * kLanes + i;
      visits.b[visits.top] = item_b.child * kLanes + j;
      visits.gap[visits.top++] = keptGap<ShowEdges>(step, gap[j][i]);
    }
  }
  raiseDeepest(visits, first);
  return false;
}

/// Whether on_pair ended it.
template <typename OnPair>
TRICOVER_INLINE bool descendBoth(const Descent& d, OnPair& on_pair) {
  Visits visits;
  visits.a[0] = visits.b[0] = kRoot;
  visits.gap[0] = -1e30f;
  visits.top = 1;
  while (visits.top > 0) {
    --visits.top;
    if (OnPair::kNarrows && visits.gap[visits.top] > on_pair.limitOf(d)) continue;
    const std::uint32_t visit_a = visits.a[visits.top], visit_b = visits.b[visits.top];
    const Item a = itemAt(d.a, visit_a), b = itemAt(d.b, visit_b);
    // Beyond this ratio of sizes floats couldn't tell the smaller one's boxes apart in the larger one's frame.
    constexpr double kAlike = 32;
    const double size_a = a.along + a.across, size_b = (b.along + b.across) * d.to_a.scale;
    const bool both = !a.leaf && !b.leaf && size_a < kAlike * size_b && size_b < kAlike * size_a;
    const bool into_a = b.leaf || (!a.leaf && size_a >= size_b);
    if (both ? enterBoth(d, a, b, visits, on_pair)
             : enterOne(d, into_a, into_a ? a : b, into_a ? b : a, visit_a, visit_b, visits, on_pair))
      return true;
  }
  return false;
}

TRICOVER_TARGET DescentResult descend(const Descent& d) {
  MeetEdges meet{{{false, 0, -1, -1}, 1e300}};
  if (descendBoth(d, meet)) return meet.hit;
  return {false, meet.clearance > 0 ? meet.clearance : 0, -1, -1};
}

TRICOVER_TARGET void visitPairs(const Descent& d, const PairVisitor& visitor) {
  ShowEdges show{{{false, 0, -1, -1}, 1e300}, visitor, d.limit};
  descendBoth(d, show);
}

#include "hierarchy/wide_shapes.h"

#undef TRICOVER_INLINE
