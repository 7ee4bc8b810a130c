// SPDX-License-Identifier: BSD-3-Clause
// Two small polygons, all edges of both, without a tree. See simd_gaps.h for Lanes.
#pragma once

#include "hierarchy/simd_shapes.h"

namespace tricover::detail::simd {

/// Of each edge or vertex a bit where a value is certainly positive and, in the upper half, one where it is certainly
/// negative.
using Signs = unsigned;

/// A bit where there is one in either half.
[[gnu::always_inline]] inline unsigned either(unsigned bits) { return (bits | bits >> 16) & 0xffff; }
[[gnu::always_inline]] inline unsigned positive(Signs signs) { return signs & 0xffff; }
[[gnu::always_inline]] inline unsigned negative(Signs signs) { return signs >> 16; }
/// Where the one is certainly positive and the other certainly negative.
[[gnu::always_inline]] inline unsigned differing(Signs p, Signs q) { return either(p & (q << 16 | q >> 16)); }

template <class Lanes, class Value>
[[gnu::always_inline]] inline Signs signsOf(int lanes, float slack, Value value) {
  const Lanes high = Lanes::all(slack), low = Lanes::all(-slack);
  const Lanes first = value(0);
  Signs signs = above(first, high) | above(low, first) << 16;
  if (lanes > kLanes) {
    const Lanes second = value(kLanes);
    signs |= above(second, high) << kLanes | above(low, second) << (16 + kLanes);
  }
  return signs;
}

/// On which side of each edge's line a point is.
template <class Lanes>
[[gnu::always_inline]] inline Signs sidesOf(int lanes, const LineLanes& lines, float x, float y, float slack) {
  return signsOf<Lanes>(
      lanes, slack, [&](int i) __attribute__((always_inline)) {
        return Lanes::load(lines.nx + i) * x + Lanes::load(lines.ny + i) * y - Lanes::load(lines.d + i);
      });
}

/// Whether a region holds a point of the frame of its lines, by the edges that a ray along x meets, to the right or, in
/// mirrored frames, to the left.
template <class Lanes>
[[gnu::always_inline]] inline Meeting holds(const SmallPolygon& polygon, const LineLanes& lines, float x, float y,
                                            float slack) {
  const unsigned edges = polygon.edges;
  const Signs start = signsOf<Lanes>(
      polygon.lanes, slack, [&](int i) __attribute__((always_inline)) { return Lanes::load(lines.y + i) - y; });
  if ((either(start) & edges) != edges) return Meeting::Unknown;
  const Signs end = polygon.ends(start);
  const unsigned up = negative(start) & positive(end) & edges, down = positive(start) & negative(end) & edges;
  if ((up | down) == 0) return Meeting::Apart;
  const Signs sides = sidesOf<Lanes>(polygon.lanes, lines, x, y, slack);
  if (((up | down) & ~either(sides)) != 0) return Meeting::Unknown;
  const int ups = __builtin_popcount(up & negative(sides)), downs = __builtin_popcount(down & positive(sides));
  const bool inside = polygon.fill == FillRule::EvenOdd ? ((ups + downs) & 1) != 0 : ups != downs;
  return inside ? Meeting::Meet : Meeting::Apart;
}

/// b's edges that may reach a's bounding box.
template <class Lanes>
[[gnu::always_inline]] inline unsigned edgesNear(const SmallPolygon& a, const SmallPolygon& b, const LineLanes& lines,
                                                 float slack) {
  // Those with both ends beyond one side of it.
  unsigned beyond = 0;
  const auto addBeyond = [&](const float* at, float low, float high) __attribute__((always_inline)) {
    const Signs left = signsOf<Lanes>(
        b.lanes, slack, [&](int i) __attribute__((always_inline)) { return Lanes::load(at + i) - low; });
    const Signs right = signsOf<Lanes>(
        b.lanes, slack, [&](int i) __attribute__((always_inline)) { return Lanes::load(at + i) - high; });
    const unsigned sides = negative(left) | (right << 16);
    beyond |= sides & b.ends(sides);
  };
  addBeyond(lines.x, a.low_x, a.high_x);
  addBeyond(lines.y, a.low_y, a.high_y);
  return b.edges & ~either(beyond);
}

/// Of polygons whose edges don't meet: whether the region holds a ring of the other, by the first of its vertices that
/// floats tell of.
template <class Lanes>
[[gnu::always_inline]] inline Meeting holdsRing(const SmallPolygon& polygon, const LineLanes& lines,
                                                const SmallPolygon& other, const LineLanes& others, float slack) {
  Meeting meeting = Meeting::Apart;
  for (unsigned firsts = other.firsts & other.edges; firsts != 0; firsts &= firsts - 1) {
    int i = __builtin_ctz(firsts);
    Meeting of_ring = holds<Lanes>(polygon, lines, others.x[i], others.y[i], slack);
    while (of_ring == Meeting::Unknown && other.next[i] > i)
      i = other.next[i], of_ring = holds<Lanes>(polygon, lines, others.x[i], others.y[i], slack);
    if (of_ring == Meeting::Meet) return of_ring;
    if (of_ring == Meeting::Unknown) meeting = of_ring;
  }
  return meeting;
}

/// Pairs of edges of which floats know nothing: for edges of b those of a.
struct DoubtfulEdges {
  /// Beyond, a descent of the trees is as good.
  static constexpr int kMost = 8;

  unsigned of_b = 0, of_a[SmallPolygon::kMost];
};

[[gnu::always_inline]] inline Meeting meetingOf(const SmallPolygon& a, const SmallPolygon& b,
                                                const DoubtfulEdges& doubtful, const EdgeCheck& check) {
  int count = 0;
  for (unsigned of_b = doubtful.of_b; of_b != 0; of_b &= of_b - 1) {
    const int j = __builtin_ctz(of_b);
    for (unsigned of_a = doubtful.of_a[j]; of_a != 0; of_a &= of_a - 1) {
      if (check.meet == nullptr || ++count > DoubtfulEdges::kMost) return Meeting::Unknown;
      if (check.meet(check.context, a.position[__builtin_ctz(of_a)], b.position[j])) return Meeting::Meet;
    }
  }
  return Meeting::Apart;
}

/// Two segments cross if the ends of each are on different sides of the other's line, and share no point if those of
/// one are on the same side. Signs are certain beyond the slack.
template <class Lanes>
Meeting fewEdgesMeet(const SmallPolygon& a, const SmallPolygon& b, const UnitMap& map, const EdgeCheck& check) {
  float x[SmallPolygon::kMost], y[SmallPolygon::kMost], nx[SmallPolygon::kMost], ny[SmallPolygon::kMost],
      d[SmallPolygon::kMost];
  mapVertices<Lanes>(b, map, x, y);
  mapHalfPlanes<Lanes>(b, map, nx, ny, d);
  const LineLanes lines_b{x, y, nx, ny, d};
  const float slack = lineSlack(map);
  DoubtfulEdges doubtful;
  for (unsigned left = edgesNear<Lanes>(a, b, lines_b, slack); left != 0; left &= left - 1) {
    const int j = __builtin_ctz(left), k = b.next[j];
    const Signs from = sidesOf<Lanes>(a.lanes, a, x[j], y[j], slack),
                to = sidesOf<Lanes>(a.lanes, a, x[k], y[k], slack);
    const Signs start = signsOf<Lanes>(
        a.lanes, slack, [&](int i) __attribute__((always_inline)) {
          return Lanes::load(a.x + i) * nx[j] + Lanes::load(a.y + i) * ny[j] - d[j];
        });
    const Signs end = a.ends(start);
    const unsigned open = a.edges & ~either((from & to) | (start & end));
    if (open == 0) continue;
    if ((differing(from, to) & differing(start, end) & open) != 0) return Meeting::Meet;
    doubtful.of_b |= 1u << j;
    doubtful.of_a[j] = open;
  }
  if (const Meeting meeting = meetingOf(a, b, doubtful, check); meeting != Meeting::Apart) return meeting;
  const Meeting in_a = holdsRing<Lanes>(a, a, b, lines_b, slack);
  if (in_a == Meeting::Meet) return in_a;
  const Meeting in_b = holdsRing<Lanes>(b, lines_b, a, a, slack);
  return in_b == Meeting::Apart ? in_a : in_b;
}

}  // namespace tricover::detail::simd
