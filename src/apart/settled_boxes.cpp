// SPDX-License-Identifier: BSD-3-Clause
#include "apart/settled_boxes.h"

namespace tricover::detail {
namespace {

template <typename IsSettled>
std::vector<bool> settledVertices(const PolygonData& polygon, IsSettled isSettled) {
  std::vector<bool> vertices(polygon.path.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) vertices[v] = isSettled(v);
  return vertices;
}

/// Blocks stand in preorder: those below one are settled before it is asked for.
std::vector<std::uint8_t> settledLanes(const PolygonData& polygon, const std::vector<bool>& vertices) {
  const std::vector<Block>& blocks = hierarchyOf(polygon).blocks;
  std::vector<std::uint8_t> lanes(blocks.size(), 0);
  for (std::size_t k = blocks.size(); k-- > 0;) {
    const Block& block = blocks[k];
    for (unsigned i = 0; i < block.count; ++i) {
      const std::size_t child = block.child[i];
      const bool settled =
          block.leaf ? vertices[child] && vertices[child + 1] : lanes[child] == (1u << blocks[child].count) - 1;
      lanes[k] = static_cast<std::uint8_t>(lanes[k] | unsigned{settled} << i);
    }
  }
  return lanes;
}

}  // namespace

SettledBoxes::SettledBoxes(const EdgeDistances& edges, std::size_t i, std::size_t j) {
  std::size_t p = i, q = j;
  double least = edges.squareBetween(p, q);
  for (const std::size_t v : {i, i + 1})
    for (const std::size_t w : {j, j + 1})
      if (const double square = edges.squareBetween(v, w); square < least) p = v, q = w, least = square;
  if (!edges.isPlain(least)) return;

  const PolygonData &a = edges.a(), &b = edges.b();
  const Double2 way = edges.between(p, q);
  const std::vector<bool> of_a =
      settledVertices(a, [&](std::size_t v) { return a.path[v] == a.path[p] || edges.isBehindOfA(way, p, v); });
  const std::vector<bool> of_b =
      settledVertices(b, [&](std::size_t w) { return b.path[w] == b.path[q] || edges.isBehindOfB(way, q, w); });
  if (!(of_a[i] && of_a[i + 1] && of_b[j] && of_b[j + 1])) return;
  a_ = settledLanes(a, of_a);
  b_ = settledLanes(b, of_b);
}

}  // namespace tricover::detail
