// SPDX-License-Identifier: BSD-3-Clause
// Small convex polygons and inner discs. See simd_gaps.h for Lanes.
#pragma once

#include "hierarchy/simd_gaps.h"

namespace tricover::detail::simd {

/// What distances from lines may be off by. Points, normals and offsets below 8 are rounded to floats and a few
/// operations follow, in all less than 64 2^-24. 8 times a gap's rounding is more.
inline float lineSlack(const UnitMap& map) {
  static_assert(8 * kGapRounding >= 64 * kFloatRoundoff);
  return static_cast<float>(8 * map.rounding + map.error);
}

/// By how much the vertex of q that is farthest back is beyond each edge of eight. Boxes and triangles are the
/// commonest polygons there are.
template <class Lanes>
[[gnu::always_inline]] inline Lanes beyond(Lanes nx, Lanes ny, Lanes d, const float* qx, const float* qy, int count) {
  Lanes least = nx * qx[0] + ny * qy[0];
  for (int j = 1; j < kLanes / 2; ++j) least = smaller(least, nx * qx[j] + ny * qy[j]);
  if (count > kLanes / 2)
    for (int j = kLanes / 2; j < kLanes; ++j) least = smaller(least, nx * qx[j] + ny * qy[j]);
  for (int j = kLanes; j < count; ++j) least = smaller(least, nx * qx[j] + ny * qy[j]);
  return least - d;
}

/// b's points in a's units.
template <class Lanes>
[[gnu::always_inline]] inline void mapPoints(const float* of_x, const float* of_y, int lanes, const UnitMap& map,
                                             float* x, float* y) {
  const auto scale = static_cast<float>(map.scale);
  for (int i = 0;;) {
    const Lanes bx = Lanes::load(of_x + i) * scale, by = Lanes::load(of_y + i) * scale;
    (turnedX(map, bx, by) + static_cast<float>(map.tx)).store(x + i);
    (turnedY(map, bx, by) + static_cast<float>(map.ty)).store(y + i);
    if ((i += kLanes) >= lanes) break;
  }
}
template <class Lanes>
[[gnu::always_inline]] inline void mapVertices(const SmallPolygon& b, const UnitMap& map, float* x, float* y) {
  mapPoints<Lanes>(b.x, b.y, b.lanes, map, x, y);
}

/// b's half planes in a's units.
template <class Lanes>
[[gnu::always_inline]] inline void mapHalfPlanes(const SmallPolygon& b, const UnitMap& map, float* nx, float* ny,
                                                 float* d) {
  for (int i = 0;;) {
    const Lanes bnx = Lanes::load(b.nx + i), bny = Lanes::load(b.ny + i);
    const Lanes anx = turnedX(map, bnx, bny), any = turnedY(map, bnx, bny);
    anx.store(nx + i);
    any.store(ny + i);
    mappedOffset(map, Lanes::load(b.d + i), anx, any).store(d + i);
    if ((i += kLanes) >= b.lanes) break;
  }
}

/// 1 + 2^-10 is far more than the quotient's. With s the sum of two radii and d the
/// distance of the centres, s - d >= (s^2 - d^2) / (2 s) where that is positive.
template <class Lanes>
double innerDepth(const InnerDiscs& a, const InnerDiscs& b, const UnitMap& map) {
  const float slack = lineSlack(map);
  const float scale = static_cast<float>(map.scale), tx = static_cast<float>(map.tx), ty = static_cast<float>(map.ty),
              reach = a.reach + b.reach * scale;
  if (tx * tx + ty * ty > reach * reach) return 0;
  float x[kLanes], y[kLanes], radius[kLanes];
  mapPoints<Lanes>(b.x, b.y, kLanes, map, x, y);
  (Lanes::load(b.radius) * scale - slack).store(radius);
  const Lanes ax = Lanes::load(a.x), ay = Lanes::load(a.y), a_radius = Lanes::load(a.radius);
  Lanes most = Lanes::all(0);
  for (int j = 0; j < b.count; ++j) {
    const Lanes dx = ax - x[j], dy = ay - y[j], sum = a_radius + radius[j];
    most = larger(most, sum * absolute(sum) - (dx * dx + dy * dy));
  }
  const float deepest = largest(most);
  if (!(deepest > slack)) return 0;
  return (deepest - slack) / (2.0 * (static_cast<double>(a.radius[0]) + radius[0]) * (1 + 0x1p-10));
}

/// Of eight or sixteen edges or vertices; where there are eight, no second one is above any.
template <class Lanes>
struct Values {
  Lanes first, second;
};

/// Of those from 0 and, if there are more, from kLanes on.
template <class Lanes, class Value>
[[gnu::always_inline]] inline Values<Lanes> valuesOf(int lanes, Value value) {
  return {value(0), lanes > kLanes ? value(kLanes) : Lanes::all(-__builtin_inff())};
}

/// The first of the largest.
struct Largest {
  float value;
  int index;
};
template <class Lanes>
[[gnu::always_inline]] inline Largest largestOf(const Values<Lanes>& values) {
  const float most = largest(larger(values.first, values.second));
  const Lanes limit = Lanes::all(most);
  const unsigned below = above(limit, values.first) | above(limit, values.second) << kLanes;
  return {most, __builtin_ctz(~below | 1u << (SmallPolygon::kMost - 1))};
}

/// The first vertex that is farthest back along an axis.
template <class Lanes>
[[gnu::always_inline]] inline int farthestBack(const float* x, const float* y, int lanes, float nx, float ny) {
  return largestOf<Lanes>(
             valuesOf<Lanes>(
                 lanes, [&](int i) __attribute__((
                            always_inline)) { return Lanes::load(x + i) * -nx + Lanes::load(y + i) * -ny; }))
      .index;
}

/// The edge with the highest score: of a normal from its polygon to the other, turned to lead from a to b, and of how
/// far the other is beyond the edge. b's vertices are at x, y in a's frame.
template <class Lanes, class Score>
[[gnu::always_inline]] inline ConvexGap bestEdge(const SmallPolygon& a, const SmallPolygon& b, const UnitMap& map,
                                                 const float* x, const float* y, Score score) {
  float bnx[SmallPolygon::kMost], bny[SmallPolygon::kMost];
  const auto of_a = [&](int i) __attribute__((always_inline)) {
    const Lanes nx = Lanes::load(a.nx + i), ny = Lanes::load(a.ny + i);
    return score(nx, ny, beyond(nx, ny, Lanes::load(a.d + i), x, y, b.count));
  };
  const auto of_b = [&](int i) __attribute__((always_inline)) {
    const Lanes own_x = Lanes::load(b.nx + i), own_y = Lanes::load(b.ny + i);
    const Lanes nx = turnedX(map, own_x, own_y), ny = turnedY(map, own_x, own_y);
    nx.store(bnx + i);
    ny.store(bny + i);
    const Lanes d = mappedOffset(map, Lanes::load(b.d + i), nx, ny);
    return score(Lanes::all(0) - nx, Lanes::all(0) - ny, beyond(nx, ny, d, a.x, a.y, a.count));
  };
  const Values<Lanes> scores_a = valuesOf<Lanes>(a.lanes, of_a), scores_b = valuesOf<Lanes>(b.lanes, of_b);
  Largest best;
  bool is_of_a;
  if (a.lanes + b.lanes == 2 * kLanes) {  // all at once
    best = largestOf<Lanes>({scores_a.first, scores_b.first});
    is_of_a = best.index < kLanes;
    best.index &= kLanes - 1;
  } else {
    const Largest best_a = largestOf<Lanes>(scores_a), best_b = largestOf<Lanes>(scores_b);
    is_of_a = best_a.value >= best_b.value;
    best = is_of_a ? best_a : best_b;
  }
  const int e = best.index;
  const int vertex = is_of_a ? farthestBack<Lanes>(x, y, b.lanes, a.nx[e], a.ny[e])
                             : farthestBack<Lanes>(a.x, a.y, a.lanes, bnx[e], bny[e]);
  return {best.value, static_cast<EdgePosition>(e), static_cast<EdgePosition>(vertex), is_of_a};
}

template <class Lanes>
ConvexGap convexGap(const SmallPolygon& a, const SmallPolygon& b, const UnitMap& map) {
  float x[SmallPolygon::kMost], y[SmallPolygon::kMost];
  mapVertices<Lanes>(b, map, x, y);
  return bestEdge<Lanes>(
      a, b, map, x, y, [](Lanes, Lanes, Lanes gap) __attribute__((always_inline)) { return gap; });
}

template <class Lanes>
ConvexGap convexEntry(const SmallPolygon& a, const SmallPolygon& b, const UnitMap& map, double way_x, double way_y,
                      double margin) {
  float x[SmallPolygon::kMost], y[SmallPolygon::kMost];
  mapVertices<Lanes>(b, map, x, y);
  const float to_x = static_cast<float>(-way_x), to_y = static_cast<float>(-way_y), beside = static_cast<float>(margin);
  return bestEdge<Lanes>(
      a, b, map, x, y, [&](Lanes nx, Lanes ny, Lanes gap) __attribute__((always_inline)) {
        return (gap - beside) / larger(nx * to_x + ny * to_y, Lanes::all(1e-30f));
      });
}

/// How far points are outside of half planes, by the one that they are farthest outside of.
template <class Lanes>
[[gnu::always_inline]] inline Lanes outside(const float* nx, const float* ny, const float* d, int count, Lanes x,
                                            Lanes y) {
  Lanes out = x * nx[0] + y * ny[0] - d[0];
  for (int k = 1; k < count; ++k) out = larger(out, x * nx[k] + y * ny[k] - d[k]);
  return out;
}

/// Of an edge that begins and ends so far outside of half planes, for each that it leaves: the larger, the sooner; it
/// is there after a share 1 / (1 + exit). 0 of those that it doesn't leave.
template <class Lanes>
[[gnu::always_inline]] inline Lanes exitOf(Lanes from, Lanes to) {
  return larger(to / larger(Lanes::all(0) - from, Lanes::all(1e-10f)), Lanes::all(0));
}

/// The half plane of a that the way between two points leaves first, if it begins inside of all.
template <class Lanes>
[[gnu::always_inline]] inline Largest firstExit(const SmallPolygon& a, float x0, float y0, float x1, float y1) {
  return largestOf<Lanes>(valuesOf<Lanes>(
      a.lanes, [&](int i) __attribute__((always_inline)) {
        const Lanes nx = Lanes::load(a.nx + i), ny = Lanes::load(a.ny + i), d = Lanes::load(a.d + i);
        return exitOf(nx * x0 + ny * y0 - d, nx * x1 + ny * y1 - d);
      }));
}

/// Of edges of b that begin and end outside of a, that of which most is inside: between where it enters the last half
/// plane and leaves the first one, if in that order. -1 if there is none.
template <class Lanes>
[[gnu::always_inline]] inline int edgeAcross(const SmallPolygon& a, const SmallPolygon& b, float* x, float* y) {
  x[b.lanes] = x[0];
  y[b.lanes] = y[0];
  const Lanes none = Lanes::all(0), whole = Lanes::all(1);
  const Largest most = largestOf<Lanes>(valuesOf<Lanes>(
      b.lanes, [&](int i) __attribute__((always_inline)) {
        const Lanes x0 = Lanes::load(x + i), y0 = Lanes::load(y + i);
        const Lanes x1 = Lanes::load(x + i + 1), y1 = Lanes::load(y + i + 1);
        Lanes entry = none, exit = none;
        for (int k = 0; k < a.count; ++k) {
          const Lanes from = x0 * a.nx[k] + y0 * a.ny[k] - a.d[k], to = x1 * a.nx[k] + y1 * a.ny[k] - a.d[k];
          entry = larger(entry, exitOf(to, from));
          exit = larger(exit, exitOf(from, to));
        }
        return (whole - entry * exit) / ((whole + entry) * (whole + exit));
      }));
  if (!(most.value > 0)) return -1;
  // In between are copies of the last vertex: the last edge leads from the last of these to the first vertex.
  return most.index < b.count ? most.index : b.count - 1;
}

/// An edge of b, whose vertices are at x, y, leads out of a from a vertex in it, or across it; or one of them lies in
/// the other, by more than the slack.
template <class Lanes>
ConvexCrossing convexCrossing(const SmallPolygon& a, const SmallPolygon& b, const UnitMap& map) {
  float x[SmallPolygon::kMost + 1], y[SmallPolygon::kMost + 1];
  mapVertices<Lanes>(b, map, x, y);
  const Lanes limit = Lanes::all(-lineSlack(map));
  unsigned in = 0, shallow = 0;
  for (int i = 0; i < b.lanes; i += kLanes) {
    const Lanes out = outside<Lanes>(a.nx, a.ny, a.d, a.count, Lanes::load(x + i), Lanes::load(y + i));
    in |= above(Lanes::all(0), out) << i;
    shallow |= above(out, limit) << i;
  }
  if (shallow == 0) return {kNoEdge, 0};
  in &= (1u << b.count) - 1;
  const unsigned next = in >> 1 | (in & 1) << (b.count - 1), leaving = in & ~next;
  const int edge = leaving != 0 ? __builtin_ctz(leaving) : edgeAcross<Lanes>(a, b, x, y);
  if (edge >= 0) {
    const int end = edge + 1 < b.count ? edge + 1 : 0;
    const int first = firstExit<Lanes>(a, x[edge], y[edge], x[end], y[end]).index;
    return {static_cast<EdgePosition>(first), static_cast<EdgePosition>(edge)};
  }
  float nx[SmallPolygon::kMost], ny[SmallPolygon::kMost], d[SmallPolygon::kMost];
  mapHalfPlanes<Lanes>(b, map, nx, ny, d);
  for (int i = 0; i < a.lanes; i += kLanes) {
    const Lanes out = outside<Lanes>(nx, ny, d, b.count, Lanes::load(a.x + i), Lanes::load(a.y + i));
    if (above(out, limit) != 0) return {};
  }
  return {0, kNoEdge};
}

}  // namespace tricover::detail::simd
