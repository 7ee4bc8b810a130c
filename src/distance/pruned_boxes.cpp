// SPDX-License-Identifier: BSD-3-Clause
#include "distance/pruned_boxes.h"

#include "hierarchy/pruned_lanes.h"

namespace tricover::detail {
namespace {

/// By vertices: an edge is pruned if both its ends are.
template <typename IsPruned>
std::vector<bool> prunedEdges(const PolygonData& polygon, IsPruned isPruned) {
  std::vector<bool> edges(polygon.path.size());
  bool start = isPruned(0);
  for (std::size_t e = 0; e + 1 < edges.size(); ++e) {
    const bool end = isPruned(e + 1);
    edges[e] = start && end;
    start = end;
  }
  return edges;
}

}  // namespace

PrunedBoxes::PrunedBoxes(const EdgeDistances& edges, std::size_t i, std::size_t j) {
  std::size_t p = i, q = j;
  double least = edges.squareBetween(p, q);
  for (const std::size_t v : {i, i + 1})
    for (const std::size_t w : {j, j + 1})
      if (const double square = edges.squareBetween(v, w); square < least) p = v, q = w, least = square;

  const PolygonData &a = edges.a, &b = edges.b;
  const Double2 way = edges.between(p, q);
  const std::vector<bool> of_a =
      prunedEdges(a, [&](std::size_t v) { return a.path[v] == a.path[p] || edges.isBehindOfA(way, p, v); });
  const std::vector<bool> of_b =
      prunedEdges(b, [&](std::size_t w) { return b.path[w] == b.path[q] || edges.isBehindOfB(way, q, w); });
  if (!(of_a[i] && of_b[j])) return;
  a_ = prunedLanes(a, of_a);
  b_ = prunedLanes(b, of_b);
}

}  // namespace tricover::detail
