// SPDX-License-Identifier: BSD-3-Clause
// Two small rings, all edges of both, without a tree. See simd_gaps.h for Lanes.
#pragma once

#include "hierarchy/simd_shapes.h"

namespace tricover::detail::simd {

/// Of each edge or vertex of a ring, a bit where a value is certainly positive, and one where it is certainly negative.
struct Signs {
  unsigned positive, negative;
};

/// The next vertex's bit in each edge's place; the last edge leads back to the first vertex.
[[gnu::always_inline]] inline unsigned next(unsigned bits, int lanes) { return bits >> 1 | (bits & 1) << (lanes - 1); }
[[gnu::always_inline]] inline Signs next(const Signs& signs, int lanes) {
  return {next(signs.positive, lanes), next(signs.negative, lanes)};
}

template <class Lanes, class Value>
[[gnu::always_inline]] inline Signs signsOf(int lanes, float slack, Value value) {
  const Lanes high = Lanes::all(slack), low = Lanes::all(-slack);
  const Lanes first = value(0);
  Signs signs{above(first, high), above(low, first)};
  if (lanes > kLanes) {
    const Lanes second = value(kLanes);
    signs.positive |= above(second, high) << kLanes;
    signs.negative |= above(low, second) << kLanes;
  }
  return signs;
}

/// A ring's lines and vertices in one frame.
struct RingView {
  const float *x, *y, *nx, *ny, *d;
  int lanes;
  FillRule fill;

  [[gnu::always_inline]] unsigned all() const { return (1u << lanes) - 1; }
};

/// On which side of each edge's line a point is.
template <class Lanes>
[[gnu::always_inline]] inline Signs sidesOf(const RingView& ring, float x, float y, float slack) {
  return signsOf<Lanes>(
      ring.lanes, slack, [&](int i) __attribute__((always_inline)) {
        return Lanes::load(ring.nx + i) * x + Lanes::load(ring.ny + i) * y - Lanes::load(ring.d + i);
      });
}

/// Whether the region holds a point, by the edges that a ray along x meets, to the right or, in mirrored frames, to the
/// left.
template <class Lanes>
[[gnu::always_inline]] inline Meeting holds(const RingView& ring, float x, float y, float slack) {
  const Signs start = signsOf<Lanes>(
      ring.lanes, slack, [&](int i) __attribute__((always_inline)) { return Lanes::load(ring.y + i) - y; });
  if ((start.positive | start.negative) != ring.all()) return Meeting::Unknown;
  const Signs end = next(start, ring.lanes);
  const unsigned up = start.negative & end.positive, down = start.positive & end.negative;
  if ((up | down) == 0) return Meeting::Apart;
  const Signs sides = sidesOf<Lanes>(ring, x, y, slack);
  if (((up | down) & ~(sides.positive | sides.negative)) != 0) return Meeting::Unknown;
  const int ups = __builtin_popcount(up & sides.negative), downs = __builtin_popcount(down & sides.positive);
  const bool inside = ring.fill == FillRule::EvenOdd ? ((ups + downs) & 1) != 0 : ups != downs;
  return inside ? Meeting::Meet : Meeting::Apart;
}

/// A bit for each edge, but those between the copies of a vertex.
[[gnu::always_inline]] inline unsigned edgesOf(const SmallRing& ring) {
  return ((1u << (ring.count - 1)) - 1) | 1u << (ring.lanes - 1);
}

/// The position of an edge's bit.
[[gnu::always_inline]] inline std::size_t positionOf(const SmallRing& ring, int edge) {
  return static_cast<std::size_t>(edge < ring.count ? edge : ring.count - 1);
}

/// b's edges that may reach a's bounding box.
template <class Lanes>
[[gnu::always_inline]] inline unsigned edgesNear(const SmallRing& a, const RingView& b, unsigned edges, float slack) {
  unsigned near = edges;
  const auto beyond = [&](unsigned bits) __attribute__((always_inline)) { near &= ~(bits & next(bits, b.lanes)); };
  const auto beyondAny = [&](const float* at, float low, float high) __attribute__((always_inline)) {
    const Signs left = signsOf<Lanes>(
        b.lanes, slack, [&](int i) __attribute__((always_inline)) { return Lanes::load(at + i) - low; });
    const Signs right = signsOf<Lanes>(
        b.lanes, slack, [&](int i) __attribute__((always_inline)) { return Lanes::load(at + i) - high; });
    beyond(left.negative);
    beyond(right.positive);
  };
  beyondAny(b.x, a.low_x, a.high_x);
  beyondAny(b.y, a.low_y, a.high_y);
  return near;
}

/// Of rings whose edges don't meet: whether the region holds the other ring, by the first of its vertices that floats
/// tell of.
template <class Lanes>
[[gnu::always_inline]] inline Meeting holdsRing(const RingView& ring, const float* x, const float* y, int count,
                                                float slack) {
  int i = 0;
  Meeting meeting = holds<Lanes>(ring, x[0], y[0], slack);
  while (meeting == Meeting::Unknown && ++i < count) meeting = holds<Lanes>(ring, x[i], y[i], slack);
  return meeting;
}

/// Pairs of edges of which floats know nothing: for edges of b those of a.
struct DoubtfulEdges {
  /// Beyond, a descent of the trees is as good.
  static constexpr int kMost = 8;

  unsigned of_b = 0, of_a[SmallRing::kMost];
};

[[gnu::always_inline]] inline Meeting meetingOf(const SmallRing& a, const SmallRing& b, const DoubtfulEdges& doubtful,
                                                const EdgeCheck& check) {
  int count = 0;
  for (unsigned of_b = doubtful.of_b; of_b != 0; of_b &= of_b - 1) {
    const int j = __builtin_ctz(of_b);
    for (unsigned of_a = doubtful.of_a[j]; of_a != 0; of_a &= of_a - 1) {
      if (check.meet == nullptr || ++count > DoubtfulEdges::kMost) return Meeting::Unknown;
      if (check.meet(check.context, positionOf(a, __builtin_ctz(of_a)), positionOf(b, j))) return Meeting::Meet;
    }
  }
  return Meeting::Apart;
}

/// Two segments cross if the ends of each are on different sides of the other's line, and share no point if those of
/// one are on the same side. Rounding as in convexMeet(): signs are certain beyond the slack.
template <class Lanes>
Meeting ringsMeet(const SmallRing& a, const SmallRing& b, const UnitMap& map, double rounding, const EdgeCheck& check) {
  float x[SmallRing::kMost], y[SmallRing::kMost], nx[SmallRing::kMost], ny[SmallRing::kMost], d[SmallRing::kMost];
  mapVertices<Lanes>(b, map, x, y);
  mapHalfPlanes<Lanes>(b, map, nx, ny, d);
  const RingView view_a{a.x, a.y, a.nx, a.ny, a.d, a.lanes, a.fill}, view_b{x, y, nx, ny, d, b.lanes, b.fill};
  const float slack = static_cast<float>(8 * rounding + map.error);
  const unsigned edges_a = edgesOf(a);
  DoubtfulEdges doubtful;
  for (unsigned left = edgesNear<Lanes>(a, view_b, edgesOf(b), slack); left != 0; left &= left - 1) {
    const int j = __builtin_ctz(left), k = j + 1 == b.lanes ? 0 : j + 1;
    const Signs from = sidesOf<Lanes>(view_a, x[j], y[j], slack), to = sidesOf<Lanes>(view_a, x[k], y[k], slack);
    const Signs start = signsOf<Lanes>(
        a.lanes, slack, [&](int i) __attribute__((always_inline)) {
          return Lanes::load(a.x + i) * nx[j] + Lanes::load(a.y + i) * ny[j] - d[j];
        });
    const Signs end = next(start, a.lanes);
    const unsigned apart = (from.positive & to.positive) | (from.negative & to.negative) |
                           (start.positive & end.positive) | (start.negative & end.negative);
    const unsigned open = edges_a & ~apart;
    if (open == 0) continue;
    const unsigned cross = ((from.positive & to.negative) | (from.negative & to.positive)) &
                           ((start.positive & end.negative) | (start.negative & end.positive));
    if ((cross & open) != 0) return Meeting::Meet;
    doubtful.of_b |= 1u << j;
    doubtful.of_a[j] = open;
  }
  if (const Meeting meeting = meetingOf(a, b, doubtful, check); meeting != Meeting::Apart) return meeting;
  const Meeting of_b = holdsRing<Lanes>(view_a, x, y, b.count, slack);
  if (of_b != Meeting::Apart) return of_b;
  return holdsRing<Lanes>(view_b, a.x, a.y, a.count, slack);
}

}  // namespace tricover::detail::simd
