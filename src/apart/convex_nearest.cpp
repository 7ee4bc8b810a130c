// SPDX-License-Identifier: BSD-3-Clause
#include "apart/convex_nearest.h"

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
/// In b's units: those nearer may meet for all that floats know, unless a single vertex is foremost.
constexpr double kCertainlyApart = 0x1p-7;

/// In a's units: beyond it, an axis as floats have it leads past the features.
constexpr double kFar = 0x1p14;

struct Point {
  double x, y;
};

unsigned bit(int i) { return 1u << i; }
bool isSingle(unsigned bits) { return (bits & (bits - 1)) == 0; }
/// Those of n edges that start or end at vertices.
unsigned edgesAt(unsigned vertices, int n) { return vertices | vertices >> 1 | (vertices & 1) << (n - 1); }

class ConvexNearest {
 public:
  ConvexNearest(const PosedPair& pair, const SmallConvex& a, const SmallConvex& b)
      : pair_(pair), map_(mapUnits(pair)), a_(a), b_(b) {}

  Meeting find() {
    const double far = std::abs(map_.tx) + std::abs(map_.ty);
    if (!(map_.error < kSupportError && map_.scale >= kLeastScale && far < kFar && squarable(pair_.b.unit)))
      return Meeting::Unknown;
    const ConvexGap gap = convexGap(a_, b_, map_);
    if (gap.gap < -8 * gapRounding(pair_) - map_.error && far < 4) return Meeting::Meet;  // as convexMeet() says
    const bool proven = gap.gap > 0 && (gap.of_a ? fromEdgeOfA(gap.edge) : fromEdgeOfB(gap.edge)) && distance_ > 0;
    return proven ? Meeting::Apart : Meeting::Unknown;
  }

  void show(DistanceSearch& search) const {
    if (single_) return search.showNear(static_cast<std::uint32_t>(edge_a_), static_cast<std::uint32_t>(edge_b_));
    for (unsigned i = edgesAt(supports_.a, a_.count); i != 0; i &= i - 1)
      for (unsigned j = edgesAt(supports_.b, b_.count); j != 0; j &= j - 1)
        search.showNear(static_cast<std::uint32_t>(__builtin_ctz(i)), static_cast<std::uint32_t>(__builtin_ctz(j)));
  }

 private:
  Point ofA(int i) const {
    const Vec2& p = pair_.a.path[static_cast<std::size_t>(i)];
    return {p.x(), p.y()};
  }
  Point ofB(int j) const {
    const ApproxPoint p = pair_.fromB(pair_.b.path[static_cast<std::size_t>(j)]);
    return {p.x, p.y};
  }
  void support(double nx, double ny) { supports_ = convexSupports(a_, b_, map_, nx, ny, kDepth * map_.scale); }
  double unitOfB() const { return pair_.b.unit; }

  /// Where q lies beside the edge from p1 to p2: `distance_` from it, on the side that n leads to.
  enum class Place { Start, Inside, End };
  Place beside(Point p1, Point p2, Point q, double nx, double ny) {
    const double wx = q.x - p1.x, wy = q.y - p1.y, ux = p2.x - p1.x, uy = p2.y - p1.y;
    const double length = std::sqrt(ux * ux + uy * uy), part = (wx * ux + wy * uy) / length;
    distance_ = wx * nx + wy * ny;
    const double inside = kInside * (distance_ + unitOfB());
    return part < inside ? Place::Start : part > length - inside ? Place::End : Place::Inside;
  }

  bool fromEdgeOfA(int e) {
    const int next = e + 1 == a_.count ? 0 : e + 1;
    const Point p1 = ofA(e), p2 = ofA(next);
    double nx = p2.y - p1.y, ny = p1.x - p2.x;
    const double factor = (nx * a_.nx[e] + ny * a_.ny[e] > 0 ? 1 : -1) / std::sqrt(nx * nx + ny * ny);
    nx *= factor, ny *= factor;
    support(nx, ny);
    if ((supports_.foremost_a & bit(e)) == 0 || (supports_.foremost_a & bit(next)) == 0) return false;
    const int q = __builtin_ctz(supports_.foremost_b);
    const Place place = beside(p1, p2, ofB(q), nx, ny);
    if (place != Place::Inside) return fromVertices(place == Place::Start ? e : next, q);
    return accept(e, q, supports_.a == (bit(e) | bit(next)) && isSingle(supports_.b));
  }

  bool fromEdgeOfB(int e) {
    const int next = e + 1 == b_.count ? 0 : e + 1;
    const Point p1 = ofB(e), p2 = ofB(next);
    double nx = p2.y - p1.y, ny = p1.x - p2.x;
    const double outx = map_.r00 * b_.nx[e] + map_.r01 * b_.ny[e], outy = map_.r10 * b_.nx[e] + map_.r11 * b_.ny[e];
    const double factor = (nx * outx + ny * outy > 0 ? -1 : 1) / std::sqrt(nx * nx + ny * ny);
    nx *= factor, ny *= factor;
    support(nx, ny);
    if ((supports_.foremost_b & bit(e)) == 0 || (supports_.foremost_b & bit(next)) == 0) return false;
    const int q = __builtin_ctz(supports_.foremost_a);
    const Place place = beside(p1, p2, ofA(q), -nx, -ny);
    if (place != Place::Inside) return fromVertices(q, place == Place::Start ? e : next);
    return accept(q, e, supports_.b == (bit(e) | bit(next)) && isSingle(supports_.a));
  }

  bool fromVertices(int v, int w) {
    if (!between(v, w)) {
      const ConvexVertices nearest = nearestVertices(a_, b_, map_);
      if (!between(v = nearest.a, w = nearest.b)) return false;
    }
    return accept(v, w, supports_.a == bit(v) && supports_.b == bit(w));
  }

  bool between(int v, int w) {
    const Point p = ofA(v), q = ofB(w);
    const double dx = q.x - p.x, dy = q.y - p.y;
    distance_ = std::sqrt(dx * dx + dy * dy);
    if (!(distance_ > 0)) return false;
    support(dx / distance_, dy / distance_);
    return (supports_.foremost_a & bit(v)) != 0 && (supports_.foremost_b & bit(w)) != 0;
  }

  bool accept(int edge_a, int edge_b, bool single) {
    const Eigen::Vector2d apart = pair_.pose_b.translation() - pair_.pose_a.translation();
    const double size = pair_.a.extent + pair_.b.extent + std::abs(apart.x()) + std::abs(apart.y());
    const double shortest = std::min(a_.shortest * pair_.a.unit, b_.shortest * pair_.b.unit);
    edge_a_ = edge_a;
    edge_b_ = edge_b;
    single_ = single && distance_ > kClear * size && distance_ * shortest > kClearProduct * size * size &&
              shortest * shortest > kClearProduct * size * size;
    return single_ || distance_ > kCertainlyApart * unitOfB();
  }

  const PosedPair& pair_;
  const UnitMap map_;
  const SmallConvex &a_, &b_;
  ConvexSupports supports_{};
  double distance_ = 0;
  int edge_a_ = 0, edge_b_ = 0;
  bool single_ = false;
};

}  // namespace

Meeting showNearestOfConvex(const PosedPair& pair, DistanceSearch& search) {
  const SmallConvex *a = hierarchyOf(pair.a).small_convex.get(), *b = hierarchyOf(pair.b).small_convex.get();
  if (a == nullptr || b == nullptr) return Meeting::Unknown;
  ConvexNearest nearest(pair, *a, *b);
  const Meeting meeting = nearest.find();
  if (meeting == Meeting::Apart) nearest.show(search);
  return meeting;
}

}  // namespace tricover::detail
