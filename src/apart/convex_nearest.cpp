// SPDX-License-Identifier: BSD-3-Clause
#include "apart/convex_nearest.h"

#include <algorithm>
#include <cmath>

#include "hierarchy/wide.h"
#include "pair/pair_descent.h"

namespace tricover::detail {
namespace {

// Separating axes guess the nearest features, and a support pass along the axis n between them proves the guess. Let v
// in a and w in b be points of the features with w - v = d n, h_a and h_b the polygons' foremost ends along n, and the
// features no deeper than a quarter of `depth` below those. Then the distance is at most d, and at least
// h_b - h_a >= d - depth / 2. Two edges that aren't both at vertices within `depth` are farther apart than that by at
// least depth / 2, and so not the nearest.
//
// kDepth is of b's unit, the smaller one, and far above a support's error on either side.
constexpr double kDepth = 0x1p-9, kLeastScale = 0x1p-4;
static_assert(kDepth * kLeastScale / 4 >= 2 * kSupportError);

// Where no other vertices are within `depth`, what leads away from the features falls behind by depth / 2 or more on a
// way of 2 units, and a point that is kInside (d + a unit of b) from an edge's ends must go that far along others to
// be beside it. So any other two edges are farther apart by a share of 2^-25 d at least, which no rounding hides where
// d is at least kClear of the coordinates: EdgeDistances is right to 2^-47. And the edges at one vertex, which hold one
// and the same nearest point, are certain to be seen so, if products of lengths are above what it is unsure of.
constexpr double kInside = 0x1p-9, kClear = 0x1p-18, kClearProduct = 0x1p-30;
/// In a's units: beyond it, an axis as floats have it leads past the features.
constexpr double kFar = 0x1p14;

unsigned bit(int i) { return 1u << i; }
/// Those of n edges that start or end at vertices.
unsigned edgesAt(unsigned vertices, int n) { return vertices | vertices >> 1 | (vertices & 1) << (n - 1); }

class ConvexSearch {
 public:
  ConvexSearch(const PosedPair& pair, const EdgeDistances& edges, const SmallRing& a, const SmallRing& b,
               const DistanceOptions& options)
      : map_(mapUnits(pair)), rounding_(gapRounding(pair)), a_(a), b_(b), edges_(edges), options_(options) {}

  ConvexNearest find(const ConvexFeatures& tried) {
    const double far = std::abs(map_.tx) + std::abs(map_.ty);
    if (!(map_.error < kSupportError && map_.scale >= kLeastScale && far < kFar && edges_.isUnscaled())) return found_;
    if (proves(tried)) {
      found_.is_proven = true;
    } else if (!(innerDiscsMeet() && meet())) {
      findByAxes(far);
    }
    return found_;
  }

 private:
  void findByAxes(double far) {
    const ConvexGap gap = convexGap(a_, b_, map_);
    if (gap.gap < -8 * rounding_ - map_.error && far < 4) {  // as convexMeet() says
      if (!meet()) found_.meeting = Meeting::Meet;
      return;
    }
    if (!(gap.gap > 0)) return;
    const int i = gap.of_a ? gap.edge : gap.vertex, j = gap.of_a ? gap.vertex : gap.edge;
    if (besideEdge(gap.of_a, i, j)) return;
    const ConvexVertices nearest = nearestVertices(a_, b_, map_);
    areNearest(nearest.a, nearest.b);
  }

  void support(double nx, double ny) { supports_ = convexSupports(a_, b_, map_, nx, ny, kDepth * map_.scale); }

  /// Roughly.
  bool innerDiscsMeet() const {
    const double reach =
        hierarchyOf(edges_.a()).inner_discs.radius[0] + hierarchyOf(edges_.b()).inner_discs.radius[0] * map_.scale;
    return reach > 0 && map_.tx * map_.tx + map_.ty * map_.ty < reach * reach;
  }

  /// Whether they are seen to.
  bool meet() {
    const ConvexCrossing crossing = convexCrossing(a_, b_, map_, rounding_);
    if (crossing.edge_a >= 0 && crossing.edge_b >= 0) {
      const std::uint32_t i = position(crossing.edge_a), j = position(crossing.edge_b);
      if (cross(i, j)) return true;
      if (!edges_.meet(i, j)) return false;
      cross(i, j, edges_.whereTheyMeet(edges_.view(i, j)));
      return true;
    }
    found_.inner_a = crossing.edge_a;
    found_.inner_b = crossing.edge_b;
    if (crossing.edge_a < 0 && crossing.edge_b < 0) return false;
    found_.meeting = Meeting::Meet;
    return true;
  }

  bool cross(std::uint32_t i, std::uint32_t j) {
    const auto point = edges_.crossing(i, j);
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
      case ConvexFeatures::kEdgeOfB:
        return besideEdge(features.kind == ConvexFeatures::kEdgeOfA, i, j);
      case ConvexFeatures::kVertices:
        return areNearest(i, j);
      case ConvexFeatures::kCrossing:
        return cross(features.edge_a, features.edge_b);
      default:
        return false;
    }
  }

  /// Whether the edge i or j and the start of the other, or an end of that edge, are the nearest features.
  bool besideEdge(bool of_a, int i, int j) {
    const SmallRing& polygon = of_a ? a_ : b_;
    const int e = of_a ? i : j, v = of_a ? j : i, next = e + 1 == polygon.count ? 0 : e + 1;
    const EdgeDistances::Foot foot = edges_.foot(of_a, position(e), position(v));
    const double inside = kInside * (foot.distance + edges_.b().unit) * foot.length;
    if (!(foot.inside >= inside)) {
      const int end = foot.at_end ? next : e;
      const int of_a_end = of_a ? end : i, of_b_end = of_a ? j : end;
      return foot.inside > 0 ? areNearest(of_a_end, of_b_end) : areNearest(of_a_end, of_b_end, foot);
    }
    const double nx = polygon.nx[e], ny = polygon.ny[e];
    if (of_a)
      support(nx, ny);
    else
      support(-(map_.r00 * nx + map_.r01 * ny), -(map_.r10 * nx + map_.r11 * ny));
    const unsigned ends = bit(e) | bit(next);
    if (!areForemost(of_a ? ends : bit(i), of_a ? bit(j) : ends)) return false;
    found_.features = {of_a ? ConvexFeatures::kEdgeOfA : ConvexFeatures::kEdgeOfB, position(i), position(j)};
    if (isUnique(of_a ? ends : bit(i), of_a ? bit(j) : ends, foot.distance))
      found_.nearest =
          foot.is_plain
              ? EdgeDistances::Nearest{foot.distance, of_a ? foot.part() : 0, of_a ? 0 : foot.part()}
              : edges_.at(edges_.startBeside(of_a, position(i), position(j)), position(i), position(j), options_);
    return true;
  }

  bool areNearest(int v, int w) { return areNearest(v, w, edges_.startToStart(position(v), position(w))); }

  bool areNearest(int v, int w, const EdgeDistances::Foot& foot) {
    const double inverse = 1 / foot.distance;
    const Double2 x = load2(edges_.poseA().data()) * foot.way, y = load2(edges_.poseA().data() + 3) * foot.way;
    support((x[0] + x[1]) * inverse, (y[0] + y[1]) * inverse);
    if (!areForemost(bit(v), bit(w))) return false;
    found_.features = {ConvexFeatures::kVertices, position(v), position(w)};
    if (isUnique(bit(v), bit(w), foot.distance))
      found_.nearest = foot.is_plain
                           ? EdgeDistances::Nearest{foot.distance, 0, 0}
                           : edges_.at(EdgeDistances::startAndStart(foot.distance), position(v), position(w), options_);
    return true;
  }

  /// Whether these vertices, which features consist of, are and the polygons are apart.
  bool areForemost(unsigned of_a, unsigned of_b) {
    if ((supports_.foremost_a & of_a) != of_a || (supports_.foremost_b & of_b) != of_b) return false;
    if (!(supports_.gap > kSupportError + map_.error)) return false;
    found_.meeting = Meeting::Apart;
    return true;
  }

  bool isUnique(unsigned of_a, unsigned of_b, double distance) {
    found_.is_unique = supports_.a == of_a && supports_.b == of_b && isClear(distance);
    if (!found_.is_unique) {
      found_.edges_a = edgesAt(supports_.a, a_.count);
      found_.edges_b = edgesAt(supports_.b, b_.count);
    }
    return found_.is_unique;
  }

  bool isClear(double distance) const {
    const double size = edges_.size(),
                 shortest = std::min(a_.shortest * edges_.a().unit, b_.shortest * edges_.b().unit);
    const double product = kClearProduct * size * size;
    return distance > kClear * size && distance * shortest > product && shortest * shortest > product;
  }

  static std::uint32_t position(int i) { return static_cast<std::uint32_t>(i); }

  const UnitMap map_;
  const double rounding_;
  const SmallRing &a_, &b_;
  const EdgeDistances& edges_;
  const DistanceOptions& options_;
  ConvexSupports supports_{};
  ConvexNearest found_;
};

}  // namespace

ConvexNearest nearestOfConvex(const EdgeDistances& edges, const SmallRing& a, const SmallRing& b,
                              const ConvexFeatures& tried, const DistanceOptions& options) {
  const PosedPair pair(edges.a(), edges.poseA(), edges.b(), edges.poseB());
  return ConvexSearch(pair, edges, a, b, options).find(tried);
}

}  // namespace tricover::detail
