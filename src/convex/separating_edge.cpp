// SPDX-License-Identifier: BSD-3-Clause
#include "convex/separating_edge.h"

#include "polygon/convexity.h"

namespace tricover::detail {
namespace {

/// The vertex that is least far along a direction, and how much less far than the first one.
struct Lowest {
  Lowest(const PolygonData& polygon, Double2 along) {
    const Vec2* vertices = polygon.path.data();
    const double first = dot(along, load2(vertices[0].data()));
    double least = first;
    for (std::uint32_t k = 1; k + 1 < polygon.path.size(); ++k) {
      const double height = dot(along, load2(vertices[k].data()));
      vertex = height < least ? k : vertex;
      least = height < least ? height : least;
    }
    below_first = least - first;
  }

  std::uint32_t vertex = 0;
  double below_first;
};

Double2 turnedBack(const Pose& pose, Double2 v) {
  const double* r = pose.data();  // columns of three
  return Double2{dot(load2(r), v), dot(load2(r + 3), v)};
}

}  // namespace

// Along a normal n as long as the edge's image u, the gap is that of the other polygon's first vertex and by how much
// its lowest one is below that. With M the size, no less than any vertex' length, in units of U |u| M:
//   the way to the first vertex   PosedPair::kWayError                                     16
//   u, and n turned back          difference 1, products sqrt2, sum 1; 2.42 more of        3.42, 2 * 2.42
//                                 either vertex' height
//   products and sums             2 of the way, 2 of either height, difference and sum 4   10
// in all below 36.
BesideEdge::BesideEdge(const PosedPair& placement, bool of_a, std::uint32_t edge) {
  const PolygonData &own = of_a ? placement.a : placement.b, &other = of_a ? placement.b : placement.a;
  const double* r = (of_a ? placement.pose_a : placement.pose_b).data();  // columns of three
  const Double2 column_0 = load2(r), column_1 = load2(r + 3);
  const Double2 edge_in_frame = load2(own.path[edge + 1].data()) - load2(own.path[edge].data());
  along = column_0 * edge_in_frame[0] + column_1 * edge_in_frame[1];
  const bool is_right = (cross(column_0, column_1) > 0) == (convexityOf(own).direction > 0);
  outwards = is_right ? Double2{along[1], -along[0]} : Double2{-along[1], along[0]};
  turned = turnedBack(of_a ? placement.pose_b : placement.pose_a, outwards);
  const Lowest least(other, turned);
  lowest = least.vertex;
  const double to_first = of_a ? dot(outwards, placement.way(own.path[edge], other.path[0]))
                               : -dot(outwards, placement.way(other.path[0], own.path[edge]));
  static_assert(3 * PosedPair::kWayError >= kUnitRows * errorOf(16 + 4 + 5 + 10));
  const Double2 lengths = absolute(along);
  error = 3 * placement.error() * (lengths[0] + lengths[1]);
  gap = to_first + least.below_first;
}

// As there, without an error of the normal itself, but of its images in both frames:
//   the way between the first vertices   PosedPair::kWayError              16
//   n turned back, on two heights each   2 * 2.42                          4.84
//   products and sums                    2 of the way, 2 of either height, differences and sums 6   12
// in all below 36.
GapAlong::GapAlong(const PosedPair& placement, Double2 normal) {
  const Lowest of_a(placement.a, turnedBack(placement.pose_a, -normal)),
      of_b(placement.b, turnedBack(placement.pose_b, normal));
  const Double2 lengths = absolute(normal);
  static_assert(3 * PosedPair::kWayError >= kUnitRows * errorOf(16 + 5 + 12));
  error = 3 * placement.error() * (lengths[0] + lengths[1]);
  gap = dot(normal, placement.way(placement.a.path[0], placement.b.path[0])) + of_a.below_first + of_b.below_first;
  support_a = of_a.vertex;
  lowest_b = of_b.vertex;
}

}  // namespace tricover::detail
