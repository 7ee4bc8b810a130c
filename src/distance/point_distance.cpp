// SPDX-License-Identifier: BSD-3-Clause
#include "distance/point_distance.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "distance/edge_distance.h"
#include "numbers/double2.h"
#include "numbers/double_double.h"
#include "pair/placement.h"
#include "pair/root_box.h"

namespace tricover::detail {
namespace {

Double2 mapped(const Pose& pose, const Vec2& p) { return load2(pose.data()) * p.x() + load2(pose.data() + 3) * p.y(); }

double sum(Double2 v) { return v[0] + v[1]; }

/// Whether neither fourth powers of such lengths overflow nor those of lengths 2^-100 times as large lose digits.
bool isPlain(double length) { return length > 0x1p-100 && length < 0x1p200; }

}  // namespace

// With M = |p|_1 + |q|_1 + |t|_1, t = t_b - t_a, rows of R being unit vectors but for 1e-6, in units of U:
//   R q + t - R p   products 1, sum 1, two more sums 2; t itself 1, two sums 2    4 M in either coordinate
//   the square      twice sqrt2 4 M |w|, products and sum 2                       halved by the root, and its own 1
// which is 5.7 M + 2 d: below 32 d, half of kRelativeError, where M <= 5 d.
double plainDistance(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b) {
  static_assert(EdgeDistances::kRelativeError >= (1 + 1e-5) * (5 * errorOf(4) * kRoot2 + errorOf(2)));
  const Double2 shift = load2(pose_b.data() + 6) - load2(pose_a.data() + 6), apart = absolute(shift);
  const Double2 way = mapped(pose_b, b.origin) + shift - mapped(pose_a, a.origin);
  const double square = sum(way * way), size = a.extent + b.extent + sum(apart);
  const double distance = std::sqrt(square);
  return square > 0x1p-900 && square < 0x1p900 && size < 4.9 * distance ? distance : -1;
}

// Let w go from a vertex v to the point q, and u along the edge from v, or to it; in units of U, rows of R being unit
// vectors but for 1e-6:
//   R v, R q        products sqrt2 in any direction, sum 1                                    2.42 |v|, 2.42 |q|
//   t               its rest is added in the end
//   R q + t         the sum: 1 of itself, which is at most |w| + |v|                          |w| + |v|
//   w               the difference 1, the rest's sum 1                                        2 |w|
// which is e = 3.42 |v| + 2.42 |q| + 3 |w|. Where w itself is nearest, its length adds 2 d, squares, sum and root.
// Where the foot of the point is inside the edge, to |u x w| / |u|
//   e               in any direction
//   u               difference 1, products sqrt2, sum 1: turns w by                           3.42 |w|
//   u x w           products |u| |w|, their difference |u| d                                  |w| + d
//   its square over that of u, 2 + 2, which the last root halves, and its own 1                3 d
// add up to 3.42 |v| + 2.42 |q| + 7.42 |w| + 4 d: below 32 d, half of kRelativeError, by the condition below. That
// condition holds for the nearest edge found with the longest w, so that no other one can be nearer by more than that.
// It also bounds the angles by which w and u are wrong by 40U: where the foot is taken to be inside the edge, or beyond
// its end, wrongly, the square of that is lost.
NearestEdge nearestEdge(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b) {
  constexpr double kOfA = 3.5, kOfB = 2.5, kOfWay = 7.5, kMost = 27;
  static_assert(EdgeDistances::kRelativeError >= (1 + 1e-5) * (kMost * kUnitRoundoff + errorOf(4)));
  static_assert(kOfA * kUnitRoundoff >= (1 + 1e-5) * (errorOf(2) + kRoot2 * errorOf(1)) &&
                kOfWay * kUnitRoundoff >= (1 + 1e-5) * (errorOf(3 + 2 + 1) + kRoot2 * errorOf(1)));
  NearestEdge best{-1, 0, Vec2::Zero(), Vec2::Zero(), true};
  const Place place = Placement(a, pose_a, b, pose_b).inUnits().origin();
  const Hierarchy& tree = hierarchyOf(a);
  std::uint32_t edges[kMostNearest];
  const int count = findNearestEdges(tree, place, edges);
  const Twofold<Double2> shift = twoSum(load2(pose_b.data() + 6), -load2(pose_a.data() + 6));
  const Double2 q = mapped(pose_b, b.origin) + shift.high;
  const double extents = kOfA * a.extent + kOfB * b.extent;
  if (!isPlain(extents + sum(absolute(shift.high)))) return best;
  double least = std::numeric_limits<double>::infinity(), longest = 0, part = 0;
  for (int i = 0; i < count; ++i) {
    const Vec2 &v1 = a.path[edges[i]], &v2 = a.path[edges[i] + 1];
    const Double2 u = mapped(pose_a, v2 - v1), w1 = (q - mapped(pose_a, v1)) + shift.low;
    const Double2 w2 = (q - mapped(pose_a, v2)) + shift.low;
    const double square = sum(u * u), along = sum(u * w1);
    // One too short for its square to have all digits is as good as its start, but isn't told apart from it here.
    if (!(square > 0x1p-400 || square == 0)) return best;
    const bool inside = along > 0 && along<square, beyond = 2 * along> square;
    const Double2 w = beyond ? w2 : w1, products = u * swapped(w);
    const double area = products[0] - products[1], found = inside ? area * area / square : sum(w * w);
    longest = std::max(longest, sum(absolute(w)));
    if (!(found < least)) continue;
    least = found;
    best.edge = edges[i];
    part = inside ? along / square : beyond ? 1 : 0;
  }
  const double distance = std::sqrt(least);
  if (!(count > 0 && extents + kOfWay * longest < kMost * distance)) return best;
  const Vec2 &v1 = a.path[best.edge], &v2 = a.path[best.edge + 1];
  const Vec2 nearest = part == 0 ? v1 : part == 1 ? v2 : Vec2(v1 + part * (v2 - v1));
  best.point_a = posed(pose_a, nearest);
  best.point_b = posed(pose_b, b.origin);
  best.distance = distance;
  best.may_be_inside = !(distanceFromRoot(tree.root, place) > 0);
  return best;
}

}  // namespace tricover::detail
