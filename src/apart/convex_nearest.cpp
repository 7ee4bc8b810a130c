// SPDX-License-Identifier: BSD-3-Clause
#include "apart/convex_nearest.h"

#include <algorithm>
#include <cmath>

#include "hierarchy/wide.h"
#include "pair/pair_descent.h"

namespace tricover::detail {
namespace {

// Separating axes guess the nearest features, and a support pass along the axis n between them proves the guess. Let v
// in a and w in b be vertices of the features, w - v = d n but for what is along an edge, and no vertex be ahead of
// them along n by more than floats' errors, kAhead of its polygon's unit. Then the distance is at most d, and at least
//   d - kAhead (unit of a + unit of b).
// Two edges one of which has both its ends behind by `depth`, as floats see it, are farther apart than d by at least
//   depth - kSupportError (its polygon's unit) - kAhead (the other's unit) >= depth / 2.
//
// `depth` is kDepth of b's unit, the smaller one, which is at least kLeastScale of a's.
//
// Doubles are off by at most 2^-47 of the coordinates, kSure / 2^20: where d is kSure of those at least, n is off by an
// angle of 2^-20, and heights by 2^-19 of a unit, which kSupportError has room for. For d itself it is the angle's
// square, 2^-27 of a's unit where d is at most kFar.
constexpr double kDepth = 0x1p-9, kLeastScale = 0x1p-4, kAhead = 2 * kSupportError;
constexpr double kSure = 0x1p-27, kFar = 0x1p14;
static_assert(kDepth * kLeastScale / 2 >= kSupportError + kAhead && kSupportError >= 4 * 0x1p-19);

// Where no other vertices are within `depth`, what leads away from the features falls behind by depth / 2 or more on a
// way of 2 units, and a point that is kInside (d + a unit of b) from an edge's ends must go that far along others to
// be beside it. So any other two edges are farther apart by a share of 2^-25 d at least, which no rounding hides where
// d is at least kClear of the coordinates: EdgeDistances is right to 2^-47. And the edges at one vertex, which hold one
// and the same nearest point, are certain to be seen so, if products of lengths are above what it is unsure of.
constexpr double kInside = 0x1p-9, kClear = 0x1p-18, kClearProduct = 0x1p-30;

unsigned bit(int i) { return 1u << i; }

class ConvexSearch {
 public:
  ConvexSearch(const PlainWays& ways, const SmallRing& a, const SmallRing& b, const DistanceOptions& options,
               ConvexNearest& found)
      : scale_(ways.b().unit * ways.a().inverse_unit), a_(a), b_(b), ways_(ways), options_(options), found_(found) {}

  void find(const ConvexFeatures& tried) {
    if (!(scale_ >= kLeastScale && ways_.isUnscaled())) return;
    found_.is_proven = proves(tried);
    if (!found_.is_proven) findAnew();
  }

 private:
  void findAnew() {
    const UnitMap map = roughMap();
    if (innerDiscsMeet(map) && meet()) return;
    const ConvexGap gap = convexGap(a_, b_, map);
    if (!(gap.gap > 0)) {
      meet();
      return;
    }
    if (gap.of_a ? besideEdge<true>(gap.edge, gap.vertex) : besideEdge<false>(gap.edge, gap.vertex)) return;
    const ConvexVertices nearest = nearestVertices(a_, b_, map);
    areNearest(nearest.a, nearest.b);
  }

  /// Good enough to guess by: the inverse of a's pose is taken for its transpose.
  UnitMap roughMap() const {
    const double *ra = ways_.poseA().data(), *rb = ways_.poseB().data();
    const Double2 x{ra[0], ra[3]}, y{ra[1], ra[4]};  // a's rows
    const Double2 m0 = x * rb[0] + y * rb[1], m1 = x * rb[3] + y * rb[4], way = ways_.betweenOrigins();
    const Double2 t = (x * way[0] + y * way[1]) * ways_.a().inverse_unit;
    return {m0[0], m1[0], m0[1], m1[1], t[0], t[1], scale_, 0};
  }

  bool innerDiscsMeet(const UnitMap& map) const {
    const double reach =
        hierarchyOf(ways_.a()).inner_discs.radius[0] + hierarchyOf(ways_.b()).inner_discs.radius[0] * map.scale;
    return reach > 0 && map.tx * map.tx + map.ty * map.ty < reach * reach;
  }

  /// Whether they are seen to.
  bool meet() {
    const PosedPair pair(ways_.a(), ways_.poseA(), ways_.b(), ways_.poseB());
    const UnitMap map = mapUnits(pair);
    if (!(std::abs(map.tx) + std::abs(map.ty) < 4)) return false;
    const ConvexCrossing crossing = convexCrossing(a_, b_, map, gapRounding(pair));
    if (crossing.edge_a >= 0 && crossing.edge_b >= 0) {
      const std::uint32_t i = position(crossing.edge_a), j = position(crossing.edge_b);
      if (cross(i, j)) return true;
      const EdgeDistances edges(ways_);
      if (!edges.meet(i, j)) return false;
      cross(i, j, edges.whereTheyMeet(edges.view(i, j)));
      return true;
    }
    found_.inner_a = crossing.edge_a;
    found_.inner_b = crossing.edge_b;
    if (crossing.edge_a < 0 && crossing.edge_b < 0) return false;
    found_.meeting = Meeting::Meet;
    return true;
  }

  bool cross(std::uint32_t i, std::uint32_t j) {
    const auto point = EdgeDistances(ways_).crossing(i, j);
    if (point) cross(i, j, *point);
    return point.has_value();
  }

  void cross(std::uint32_t i, std::uint32_t j, const EdgeDistances::Nearest& point) {
    found_.meeting = Meeting::Meet;
    found_.features = {ConvexFeatures::kCrossing, i, j};
    found_.is_unique = true;
    found_.nearest = point;
  }

  bool proves(const ConvexFeatures& features) {
    const int i = static_cast<int>(features.edge_a), j = static_cast<int>(features.edge_b);
    switch (features.kind) {
      case ConvexFeatures::kEdgeOfA:
        return besideEdge<true>(i, j);
      case ConvexFeatures::kEdgeOfB:
        return besideEdge<false>(j, i);
      case ConvexFeatures::kVertices:
        return areNearest(i, j);
      case ConvexFeatures::kCrossing:
        return cross(features.edge_a, features.edge_b);
      default:
        return false;
    }
  }

  /// Whether edge e of one and vertex v of the other, or an end of that edge, are the nearest features.
  template <bool kEdgeOfA>
  bool besideEdge(int e, int v) {
    const SmallRing& polygon = kEdgeOfA ? a_ : b_;
    const int next = e + 1 == polygon.count ? 0 : e + 1;
    const PlainWays::Foot foot = ways_.foot<kEdgeOfA>(position(e), position(v));
    if (!(foot.inside >= kInside * (foot.distance + ways_.b().unit) * foot.length)) {
      const int end = foot.at_end ? next : e, i = kEdgeOfA ? end : v, j = kEdgeOfA ? v : end;
      return foot.inside > 0 ? areNearest(i, j) : areNearest(i, j, foot);
    }
    const int i = kEdgeOfA ? e : v, j = kEdgeOfA ? v : e;
    const unsigned ends = bit(e) | bit(next);
    if (!areForemost(i, j, kEdgeOfA ? ends : bit(i), kEdgeOfA ? bit(j) : ends, foot)) return false;
    found_.features = {kEdgeOfA ? ConvexFeatures::kEdgeOfA : ConvexFeatures::kEdgeOfB, position(i), position(j)};
    if (!found_.is_unique) return true;
    if (foot.is_plain)
      found_.nearest = {foot.distance, kEdgeOfA ? foot.part() : 0, kEdgeOfA ? 0 : foot.part()};
    else
      found_.nearest = EdgeDistances(ways_).startBeside(kEdgeOfA, foot, position(i), position(j), options_);
    return true;
  }

  bool areNearest(int v, int w) { return areNearest(v, w, ways_.startToStart(position(v), position(w))); }

  bool areNearest(int v, int w, const PlainWays::Foot& foot) {
    if (!areForemost(v, w, bit(v), bit(w), foot)) return false;
    found_.features = {ConvexFeatures::kVertices, position(v), position(w)};
    if (!found_.is_unique) return true;
    if (foot.is_plain)
      found_.nearest = {foot.distance, 0, 0};
    else
      found_.nearest = EdgeDistances(ways_).startAndStart(foot, position(v), position(w), options_);
    return true;
  }

  static FacingVertex facing(const Pose& pose, int vertex, Double2 n, double scale) {
    const double* r = pose.data();  // columns of three
    const Double2 rows[] = {{r[0], r[3]}, {r[1], r[4]}}, axis = rows[0] * n[0] + rows[1] * n[1];
    return {vertex, static_cast<float>(axis[0]), static_cast<float>(axis[1]), static_cast<float>(kDepth * scale)};
  }

  /// Whether features are foremost that consist of these vertices, v and w among them, and the polygons are apart.
  bool areForemost(int v, int w, unsigned of_a, unsigned of_b, const EdgeDistances::Foot& foot) {
    const ConvexSupports supports =
        convexSupports(a_, b_, facing(ways_.poseA(), v, foot.axis, scale_), facing(ways_.poseB(), w, -foot.axis, 1));
    const double distance = foot.distance, unit = ways_.a().unit;
    if (!(distance <= kFar * unit)) return false;
    found_.is_unique = supports.near_a == of_a && supports.near_b == of_b && isClear(distance);
    if (!found_.is_unique) {
      if (supports.any_ahead != 0 || !(distance > 4 * kAhead * unit && distance > kSure * ways_.size())) return false;
      found_.edges_a = edgesAt(supports.near_a, a_.count);
      found_.edges_b = edgesAt(supports.near_b, b_.count);
    }
    found_.meeting = Meeting::Apart;
    return true;
  }

  bool isClear(double distance) const {
    const double size = ways_.size(), shortest = std::min(a_.shortest * ways_.a().unit, b_.shortest * ways_.b().unit);
    const double product = kClearProduct * size * size;
    return distance > kClear * size && distance * shortest > product && shortest * shortest > product;
  }

  static std::uint32_t position(int i) { return static_cast<std::uint32_t>(i); }

  const double scale_;  ///< b's unit in a's
  const SmallRing &a_, &b_;
  const PlainWays& ways_;
  const DistanceOptions& options_;
  ConvexNearest& found_;
};

}  // namespace

void nearestOfConvex(const PlainWays& ways, const SmallRing& a, const SmallRing& b, const ConvexFeatures& tried,
                     const DistanceOptions& options, ConvexNearest& found) {
  ConvexSearch(ways, a, b, options, found).find(tried);
}

}  // namespace tricover::detail
