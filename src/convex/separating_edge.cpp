// SPDX-License-Identifier: BSD-3-Clause
#include "convex/separating_edge.h"

#include "polygon/convexity.h"

namespace tricover::detail {

// Along a normal n as long as the edge's image u, the gap is that of the other polygon's first vertex and by how much
// its lowest one is below that. With M the size, no less than any vertex' length, in units of U |u| M:
//   the way to the first vertex   Placement::kWayError                                     16
//   u, and n turned back          difference 1, products sqrt2, sum 1; 2.42 more of        3.42, 2 * 2.42
//                                 either vertex' height
//   products and sums             2 of the way, 2 of either height, difference and sum 4   10
// in all below 36.
BesideEdge::BesideEdge(const Placement& placement, bool of_a, std::uint32_t edge) {
  const PolygonData &own = of_a ? placement.a : placement.b, &other = of_a ? placement.b : placement.a;
  const double *r = (of_a ? placement.pose_a : placement.pose_b).data(),
               *s = (of_a ? placement.pose_b : placement.pose_a).data();  // columns of three
  const Double2 column_0 = load2(r), column_1 = load2(r + 3);
  const Double2 edge_in_frame = load2(own.path[edge + 1].data()) - load2(own.path[edge].data());
  along = column_0 * edge_in_frame[0] + column_1 * edge_in_frame[1];
  const bool is_right = (cross(column_0, column_1) > 0) == (convexityOf(own).direction > 0);
  outwards = is_right ? Double2{along[1], -along[0]} : Double2{-along[1], along[0]};
  turned = Double2{dot(load2(s), outwards), dot(load2(s + 3), outwards)};
  const Vec2* vertices = other.path.data();
  const double first = dot(turned, load2(vertices[0].data()));
  double least = first;
  lowest = 0;
  for (std::uint32_t k = 1; k + 1 < other.path.size(); ++k) {
    const double height = dot(turned, load2(vertices[k].data()));
    lowest = height < least ? k : lowest;
    least = height < least ? height : least;
  }
  const double to_first = of_a ? dot(outwards, placement.way(own.path[edge], vertices[0]))
                               : -dot(outwards, placement.way(vertices[0], own.path[edge]));
  static_assert(3 * Placement::kWayError >= kUnitRows * errorOf(16 + 4 + 5 + 10));
  const Double2 lengths = absolute(along);
  error = 3 * placement.error() * (lengths[0] + lengths[1]);
  gap = to_first + (least - first);
}

}  // namespace tricover::detail
