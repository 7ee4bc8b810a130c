// SPDX-License-Identifier: BSD-3-Clause
#include "pair/kernel_order.h"

#include <utility>
#include <vector>

namespace tricover::detail {
namespace {

using EdgeNumbers = std::array<double, 4>;

bool areInOrder(const EdgeNumbers& e, const EdgeNumbers& f) {
  return std::lexicographical_compare(e.begin(), e.end(), f.begin(), f.end(), isSmaller);
}

/// The edges in an order of their own, each from its lesser end: rings may begin anywhere and run either way.
std::vector<EdgeNumbers> sortedEdges(const PolygonData& polygon) {
  std::vector<EdgeNumbers> edges;
  edges.reserve(polygon.path.size());
  for (std::size_t ring = 0; ring < polygon.ringCount(); ++ring)
    for (EdgePosition e = polygon.edgeBegin(ring); e < polygon.edgeEnd(ring); ++e) {
      const Vec2 &v = polygon.path[e], &w = polygon.path[e + 1];
      const EdgeNumbers forth{v.x(), v.y(), w.x(), w.y()}, back{w.x(), w.y(), v.x(), v.y()};
      edges.push_back(areInOrder(back, forth) ? back : forth);
    }
  std::sort(edges.begin(), edges.end(), areInOrder);
  return edges;
}

}  // namespace

int compareEdges(const PolygonData& a, const PolygonData& b) {
  const std::vector<EdgeNumbers> p = sortedEdges(a), q = sortedEdges(b);
  if (std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end(), areInOrder)) return -1;
  if (std::lexicographical_compare(q.begin(), q.end(), p.begin(), p.end(), areInOrder)) return 1;
  if (a.fill.rule == FillRule::EvenOdd) return 0;
  // Under the non-zero rule the same edges may bound another region: there, directions matter, too.
  for (std::size_t k = 0; k < a.path.size(); ++k)
    for (const int i : {0, 1})
      if (const double x = a.path[k][i], y = b.path[k][i]; isSmaller(x, y) || isSmaller(y, x))
        return isSmaller(x, y) ? -1 : 1;
  return 0;
}

}  // namespace tricover::detail
