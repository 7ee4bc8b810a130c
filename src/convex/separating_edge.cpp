// SPDX-License-Identifier: BSD-3-Clause
#include "convex/separating_edge.h"

#include <algorithm>

#include "polygon/convexity.h"

namespace tricover::detail {

// Along a normal n as long as the edge's image u, the gap is that of the other polygon's first vertex and by how much
// its lowest one is below that. With M the size, no less than any vertex' length, in units of U |u| M:
//   the way to the first vertex   Placement::kWayError                                     16
//   u, and n turned back          difference 1, products sqrt2, sum 1; 2.42 more of        3.42, 2 * 2.42
//                                 either vertex' height
//   products and sums             2 of the way, 2 of either height, difference and sum 4   10
// in all below 36.
bool isSeparatingEdge(const Placement& placement, bool of_a, std::size_t edge) {
  const PolygonData &own = of_a ? placement.a : placement.b, &other = of_a ? placement.b : placement.a;
  const double *r = (of_a ? placement.pose_a : placement.pose_b).data(),
               *s = (of_a ? placement.pose_b : placement.pose_a).data();  // columns of three
  const Double2 column_0 = load2(r), column_1 = load2(r + 3);
  const Double2 along = load2(own.path[edge + 1].data()) - load2(own.path[edge].data());
  const Double2 u = column_0 * along[0] + column_1 * along[1];
  const bool is_right = (cross(column_0, column_1) > 0) == (convexityOf(own).direction > 0);
  const Double2 outwards = is_right ? Double2{u[1], -u[0]} : Double2{-u[1], u[0]};
  const Double2 turned{dot(load2(s), outwards), dot(load2(s + 3), outwards)};
  const Vec2* vertices = other.path.data();
  const double first = dot(turned, load2(vertices[0].data()));
  double least = first;
  for (std::size_t k = 1; k + 1 < other.path.size(); ++k)
    least = std::min(least, dot(turned, load2(vertices[k].data())));
  const double to_first = of_a ? dot(outwards, placement.way(own.path[edge], vertices[0]))
                               : -dot(outwards, placement.way(vertices[0], own.path[edge]));
  static_assert(3 * Placement::kWayError >= kUnitRows * errorOf(16 + 4 + 5 + 10));
  const Double2 lengths = absolute(u);
  const double bound = 3 * placement.error() * (lengths[0] + lengths[1]);
  // Neither do products overflow nor does what underflows matter.
  return bound > 0x1p-900 && bound < 0x1p900 && to_first + (least - first) > bound;
}

}  // namespace tricover::detail
