// SPDX-License-Identifier: BSD-3-Clause
#include "overlap/vertex_stars.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tricover::detail {
namespace {

std::vector<std::uint32_t> placesOf(const std::vector<Vec2>& path) {
  std::vector<std::uint32_t> order(path.size()), places(path.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto isBefore = [&](std::uint32_t v, std::uint32_t w) {
    return path[v].x() != path[w].x() ? path[v].x() < path[w].x() : path[v].y() < path[w].y();
  };
  std::sort(order.begin(), order.end(), isBefore);
  for (std::size_t k = 0; k < order.size(); ++k)
    places[order[k]] = k > 0 && path[order[k]] == path[order[k - 1]] ? places[order[k - 1]] : order[k];
  return places;
}

}  // namespace

VertexStars::VertexStars(const PosedPair& pair)
    : pair_(pair), place_a_(placesOf(pair.a.path)), place_b_(placesOf(pair.b.path)) {}

bool VertexStars::isKnown(std::size_t i, std::size_t j) {
  for (const std::size_t u : {i, i + 1}) {
    const Vec2& p = pair_.a.path[u];
    for (const std::size_t v : {j, j + 1}) {
      const ApproxPoint q = pair_.fromB(pair_.b.path[v]);
      if (!(std::abs(q.x - p.x()) <= q.error && std::abs(q.y - p.y()) <= q.error)) continue;
      const PosedPoint at_a{&pair_.pose_a, p}, at_b{&pair_.pose_b, pair_.b.path[v]};
      Star& star = stars_[std::uint64_t{place_a_[u]} << 32 | place_b_[v]];
      if (star.state == New) star = {betweenExact(at_a, at_b, at_b) ? Met : Apart, i, j};
      if (star.state != Met || i == star.edge_a || j == star.edge_b) return false;
      const Vec2 &of_a = pair_.a.path[2 * i + 1 - u], &of_b = pair_.b.path[2 * j + 1 - v];
      const int turn = orientFilter(PosedPair::fromA(p), PosedPair::fromA(of_a), pair_.fromB(of_b));
      return turn == 1 || turn == -1;
    }
  }
  return false;
}

}  // namespace tricover::detail
