// SPDX-License-Identifier: BSD-3-Clause
// Distances of two small polygons, all edges of both, without a tree. See simd_gaps.h for Lanes.
#pragma once

#include "hierarchy/simd_shapes.h"

namespace tricover::detail::simd {

/// A polygon's edges, as SmallPolygon has them, in one frame.
struct EdgeView {
  const float *nx, *ny, *d, *middle, *half;
};

template <class Ring>
[[gnu::always_inline]] inline EdgeView edgesOf(const Ring& ring) {
  return {ring.nx, ring.ny, ring.d, ring.middle, ring.half};
}

/// The square of a point's distance from an edge: besideSegment() where the edge's line and middle are known.
template <class Lanes>
[[gnu::always_inline]] inline Lanes squareBeside(Lanes nx, Lanes ny, Lanes d, Lanes middle, Lanes half, Lanes x,
                                                 Lanes y) {
  const Lanes away = nx * x + ny * y - d;
  const Lanes past = larger(absolute(nx * y - ny * x - middle) - half, Lanes::all(0));
  return away * away + past * past;
}

/// Of eight edges, each from that of these vertices that is the nearest to it.
template <class Lanes>
[[gnu::always_inline]] inline Lanes leastSquares(const EdgeView& edges, int i, const float* x, const float* y,
                                                 int count) {
  const Lanes nx = Lanes::load(edges.nx + i), ny = Lanes::load(edges.ny + i), d = Lanes::load(edges.d + i);
  const Lanes middle = Lanes::load(edges.middle + i), half = Lanes::load(edges.half + i);
  Lanes least = Lanes::all(1e30f);
  for (int j = 0; j < count; ++j)
    least = smaller(least, squareBeside(nx, ny, d, middle, half, Lanes::all(x[j]), Lanes::all(y[j])));
  return least;
}

/// A bit for each vertex whose distance from the edge has at most this square.
template <class Lanes>
[[gnu::always_inline]] inline unsigned verticesWithin(const EdgeView& edges, int e, const float* x, const float* y,
                                                      int lanes, int count, float square) {
  const Lanes nx = Lanes::all(edges.nx[e]), ny = Lanes::all(edges.ny[e]), d = Lanes::all(edges.d[e]);
  const Lanes middle = Lanes::all(edges.middle[e]), half = Lanes::all(edges.half[e]);
  unsigned beyond = 0;
  for (int i = 0; i < lanes; i += kLanes)
    beyond |= above(squareBeside(nx, ny, d, middle, half, Lanes::load(x + i), Lanes::load(y + i)), Lanes::all(square))
              << i;
  return ~beyond & ((1u << count) - 1);
}

template <class Lanes>
void smallGaps(const SmallPolygon& a, const SmallPolygon& b, const UnitMap& map, SmallGaps& gaps) {
  mapVertices<Lanes>(b, map, gaps.x, gaps.y);
  mapHalfPlanes<Lanes>(b, map, gaps.nx, gaps.ny, gaps.d);
  const FloatMap to_a(map);
  // A mirror image has the direction along the edge, which is across the normal, the other way round.
  const float turn = map.r00 * map.r11 < map.r01 * map.r10 ? -to_a.scale : to_a.scale;
  for (int i = 0; i < b.lanes; i += kLanes) {
    (Lanes::load(b.middle + i) * turn + Lanes::load(gaps.nx + i) * to_a.ty - Lanes::load(gaps.ny + i) * to_a.tx)
        .store(gaps.middle + i);
    (Lanes::load(b.half + i) * to_a.scale).store(gaps.half + i);
  }
  const EdgeView edges_a = edgesOf(a), edges_b = edgesOf(gaps);
  Lanes least = Lanes::all(1e30f);
  for (int i = 0; i < a.lanes; i += kLanes) {
    const Lanes squares = leastSquares<Lanes>(edges_a, i, gaps.x, gaps.y, b.count);
    squares.store(gaps.of_a + i);
    least = smaller(least, squares);
  }
  for (int i = 0; i < b.lanes; i += kLanes) {
    const Lanes squares = leastSquares<Lanes>(edges_b, i, a.x, a.y, a.count);
    squares.store(gaps.of_b + i);
    least = smaller(least, squares);
  }
  gaps.least = -largest(Lanes::all(0) - least);
}

/// The edges that start or end at vertices, a bit each.
[[gnu::always_inline]] inline unsigned edgesAt(const SmallPolygon& polygon, unsigned vertices) {
  return vertices | polygon.ends(vertices);
}

template <class Lanes>
void nearEdges(const SmallPolygon& a, const SmallPolygon& b, const SmallGaps& gaps, float square,
               unsigned (&near)[SmallPolygon::kMost]) {
  const EdgeView edges_a = edgesOf(a), edges_b = edgesOf(gaps);
  for (int i = 0; i < a.count; ++i)
    near[i] = gaps.of_a[i] > square
                  ? 0
                  : edgesAt(b, verticesWithin<Lanes>(edges_a, i, gaps.x, gaps.y, b.lanes, b.count, square));
  for (int j = 0; j < b.count; ++j) {
    if (gaps.of_b[j] > square) continue;
    unsigned of_a = edgesAt(a, verticesWithin<Lanes>(edges_b, j, a.x, a.y, a.lanes, a.count, square));
    for (; of_a != 0; of_a &= of_a - 1) near[__builtin_ctz(of_a)] |= 1u << j;
  }
}

}  // namespace tricover::detail::simd
