// SPDX-License-Identifier: BSD-3-Clause
#include "impact/vertex_paths.h"

namespace tricover::detail {

double leverOf(const Mover& mover, const Vec2& vertex) {
  const Vec2 lever = mover.arm + mover.scale * (mover.linear * vertex);
  return lengthAbove(lever.x(), lever.y());
}

Rest restOfEdges(const TimeInterval& interval, std::size_t edge_a, std::size_t edge_b) {
  Approach first;
  for (const bool of_b : {false, true}) {
    const VertexView view(interval, of_b);
    const Mover &of = of_b ? interval.pair.b : interval.pair.a, &from = of_b ? interval.pair.a : interval.pair.b;
    const std::size_t own = of_b ? edge_b : edge_a, other = of_b ? edge_a : edge_b;
    const EdgeInUnits edge(*from.polygon, other);
    for (std::uint32_t end = 0; end < 2; ++end) {
      const Vec2 vertex = of.polygon->inUnits(of.polygon->path[own + end]);
      view.approach(view.pathOf(vertex, leverOf(of, vertex)), edge, end, 0, first);
    }
  }
  return {first.share, 1, first.aim};
}

}  // namespace tricover::detail
