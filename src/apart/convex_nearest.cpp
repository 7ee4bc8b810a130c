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
// d is at least kClear of the coordinates: EdgeDistances is right to 2^-48. And the edges at one vertex, which hold one
// and the same nearest point, are certain to be seen so, if products of lengths are above what it is unsure of.
constexpr double kInside = 0x1p-9, kClear = 0x1p-18, kClearProduct = 0x1p-30;
/// In a's units: beyond it, an axis as floats have it leads past the features.
constexpr double kFar = 0x1p14;

unsigned bit(int i) { return 1u << i; }
/// Those of n edges that start or end at vertices.
unsigned edgesAt(unsigned vertices, int n) { return vertices | vertices >> 1 | (vertices & 1) << (n - 1); }

class ConvexNearest {
 public:
  ConvexNearest(const PosedPair& pair, const SmallConvex& a, const SmallConvex& b, DistanceSearch& search)
      : pair_(pair), map_(mapUnits(pair)), a_(a), b_(b), edges_(search.edges()), search_(search) {}

  Meeting find(ConvexFeatures& features, Outcome& inside) {
    const double far = std::abs(map_.tx) + std::abs(map_.ty);
    if (!(map_.error < kSupportError && map_.scale >= kLeastScale && far < kFar && edges_.isUnscaled()))
      return Meeting::Unknown;
    if (proves(features)) return Meeting::Apart;
    if (innerDiscsMeet() && findsMeeting(inside)) return Meeting::Meet;
    const ConvexGap gap = convexGap(a_, b_, map_);
    if (gap.gap < -8 * gapRounding(pair_) - map_.error && far < 4) {  // as convexMeet() says
      findsMeeting(inside);
      return Meeting::Meet;
    }
    if (!(gap.gap > 0)) return Meeting::Unknown;
    const int i = gap.of_a ? gap.edge : gap.vertex, j = gap.of_a ? gap.vertex : gap.edge;
    if (!besideEdge(gap.of_a, i, j)) {
      const ConvexVertices nearest = nearestVertices(a_, b_, map_);
      if (!areNearest(nearest.a, nearest.b)) return Meeting::Unknown;
    }
    features = found_;
    return Meeting::Apart;
  }

 private:
  void support(double nx, double ny) { supports_ = convexSupports(a_, b_, map_, nx, ny, kDepth * map_.scale); }

  /// Roughly.
  bool innerDiscsMeet() const {
    const double reach =
        hierarchyOf(pair_.a).inner_discs.radius[0] + hierarchyOf(pair_.b).inner_discs.radius[0] * map_.scale;
    return reach > 0 && map_.tx * map_.tx + map_.ty * map_.ty < reach * reach;
  }

  bool findsMeeting(Outcome& inside) {
    const ConvexCrossing crossing = convexCrossing(a_, b_, map_, gapRounding(pair_));
    if (crossing.edge_a >= 0 && crossing.edge_b >= 0) {
      const std::uint32_t i = position(crossing.edge_a), j = position(crossing.edge_b);
      if (!edgesMeet(pair_, i, j)) return false;
      search_.setMeeting(i, j);
      return true;
    }
    inside.edge_a = crossing.edge_a;
    inside.edge_b = crossing.edge_b;
    return inside.collides = crossing.edge_a >= 0 || crossing.edge_b >= 0;
  }

  bool proves(ConvexFeatures& features) {
    if (features.kind == ConvexFeatures::kNone) return false;
    const int i = static_cast<int>(features.edge_a), j = static_cast<int>(features.edge_b);
    const bool proven = features.kind == ConvexFeatures::kVertices
                            ? areNearest(i, j)
                            : besideEdge(features.kind == ConvexFeatures::kEdgeOfA, i, j);
    features = found_;
    features.proven = proven;
    return proven;
  }

  /// Whether the edge i or j and the start of the other, or an end of that edge, are the nearest features.
  bool besideEdge(bool of_a, int i, int j) {
    const SmallConvex& polygon = of_a ? a_ : b_;
    const int e = of_a ? i : j, next = e + 1 == polygon.count ? 0 : e + 1;
    const EdgeDistances::View view = edges_.startBeside(of_a, position(i), position(j));
    const double along = view.along[view.nearest], square = view.length_square[view.nearest / 2];
    const double inside = kInside * (view.distance + pair_.b.unit) * std::sqrt(square);
    if (!(along >= inside && along <= square - inside)) {
      const int end = along < inside ? e : next;
      return of_a ? areNearest(end, j) : areNearest(i, end);
    }
    const double nx = polygon.nx[e], ny = polygon.ny[e];
    if (of_a)
      support(nx, ny);
    else
      support(-(map_.r00 * nx + map_.r01 * ny), -(map_.r10 * nx + map_.r11 * ny));
    const unsigned ends = bit(e) | bit(next);
    return of_a ? show(view, {ConvexFeatures::kEdgeOfA, position(i), position(j)}, ends, bit(j))
                : show(view, {ConvexFeatures::kEdgeOfB, position(i), position(j)}, bit(i), ends);
  }

  bool areNearest(int v, int w) {
    const Double2 way = edges_.between(position(v), position(w)), squares = way * way;
    const double distance = std::sqrt(squares[0] + squares[1]), inverse = 1 / distance;
    const Double2 x = load2(pair_.pose_a.data()) * way, y = load2(pair_.pose_a.data() + 3) * way;
    support((x[0] + x[1]) * inverse, (y[0] + y[1]) * inverse);
    return show(EdgeDistances::startAndStart(distance), {ConvexFeatures::kVertices, position(v), position(w)}, bit(v),
                bit(w));
  }

  /// Whether these vertices, which the features that the view shows consist of, are foremost.
  bool show(const EdgeDistances::View& view, const ConvexFeatures& features, unsigned of_a, unsigned of_b) {
    if ((supports_.foremost_a & of_a) != of_a || (supports_.foremost_b & of_b) != of_b) return false;
    if (!(supports_.gap > kSupportError + map_.error)) return false;
    found_ = features;
    if (supports_.a == of_a && supports_.b == of_b && isClear(view.distance)) {
      search_.setNearest(features.edge_a, features.edge_b, view);
      return true;
    }
    for (unsigned v = edgesAt(supports_.a, a_.count); v != 0; v &= v - 1)
      for (unsigned w = edgesAt(supports_.b, b_.count); w != 0; w &= w - 1)
        search_.showNear(position(__builtin_ctz(v)), position(__builtin_ctz(w)));
    return true;
  }

  bool isClear(double distance) const {
    const double size = edges_.size(), shortest = std::min(a_.shortest * pair_.a.unit, b_.shortest * pair_.b.unit);
    const double product = kClearProduct * size * size;
    return distance > kClear * size && distance * shortest > product && shortest * shortest > product;
  }

  static std::uint32_t position(int i) { return static_cast<std::uint32_t>(i); }

  const PosedPair& pair_;
  const UnitMap map_;
  const SmallConvex &a_, &b_;
  const EdgeDistances& edges_;
  DistanceSearch& search_;
  ConvexSupports supports_{};
  ConvexFeatures found_;
};

}  // namespace

Meeting showNearestOfConvex(const PosedPair& pair, DistanceSearch& search, ConvexFeatures& features, Outcome& inside) {
  const SmallConvex *a = hierarchyOf(pair.a).small_convex.get(), *b = hierarchyOf(pair.b).small_convex.get();
  if (a == nullptr || b == nullptr) return Meeting::Unknown;
  return ConvexNearest(pair, *a, *b, search).find(features, inside);
}

}  // namespace tricover::detail
