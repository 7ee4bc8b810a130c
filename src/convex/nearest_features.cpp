// SPDX-License-Identifier: BSD-3-Clause
#include "convex/nearest_features.h"

#include <algorithm>
#include <cmath>

#include "convex/walk_to_nearest.h"
#include "hierarchy/simd.h"

namespace tricover::detail {
namespace {

// Let v in a and w in b be vertices of features that are guessed to be the nearest, d their distance and n the axis
// between them, from a to b. Heights are along n. Along a convex ring they fall from the highest vertex to the lowest
// one on either side, so that who knows both neighbours of a feature knows all vertices.
//
// kNear of the size is more than rounding, where d is kSure of it:
//   2^-46   n leads along w - v but for an angle of 2^-23
//   16U     a height
//   64U     d
// If no neighbour is ahead by kNear / 4, and those up to kNear behind are near as well, then edges without a near
// vertex are farther apart than d by kNear / 2 at least.
constexpr double kNear = 0x1p-40, kSure = 0x1p-27;
static_assert(kNear / 4 >= 0x1p-46 + 2 * (16 + 64) * kUnitRoundoff);

// The features alone hold the distance where
//   their neighbours are behind by kLeastDepth of d, and by kLeastSlope of the way there;
//   the foot beside an edge is kInside of d or more from its ends.
// Then any points x and y of two other edges are farther apart than d, by a share of at least
//   kLeastDepth               of the height between them, where x is a neighbour or beyond;
//   kInside kLeastSlope / 2   of that height, where both x and y are aside from the foot by kInside d / 2;
//   kInside^2 / 8             of a slant way, where one of them is so, and the other isn't.
// All are more than kLeastFarther, and that is more than EdgeDistances is wrong by, whichever edges it evaluates. In
// the slopes n may be wrong by 2^-31: where d isn't plain, it is kClear of the size.
constexpr double kLeastDepth = 0x1p-38, kLeastSlope = 0x1p-20, kInside = 0x1p-18, kClear = 0x1p-18;
constexpr double kLeastFarther = 0x1p-40;
static_assert(kLeastDepth > kLeastFarther && kInside * kLeastSlope / 2 > kLeastFarther &&
              kInside * kInside / 8 > kLeastFarther && kLeastFarther > 4 * PosedVertices::kRelativeError);

// Where d isn't plain, EdgeDistances is certain of where the foot is: products of lengths are above what it is unsure
// of.
constexpr double kClearProduct = 0x1p-43;

// Below kClear the axis between two vertices is known by two-fold numbers only, that across an edge as ever. On which
// side of the edge the vertex is, is certain down to kSide of the size, and so is the axis: in units of U the way is
// off by 10 of it, and turned by 4 with u.
constexpr double kSide = 0x1p-44;
static_assert(kSide >= 2 * kUnitRows * errorOf(10 + 4));

/// In a's units: a gap that floats don't tell from none.
constexpr float kFloatDoubt = 0x1p-17f;

constexpr int kMostNear = 8;

// Where the feature is an edge, its neighbours are as far behind as the polygon's edge_depth tells of all edges, in the
// polygon's frame: kKept of it is left by a pose that misses keeping areas and lengths, and by n, which is off by less
// than a thousandth of what clear corners turn by.
constexpr double kKept = 0.5;
static_assert(kKept * kClearCorner >= kLeastSlope && kKept < 1 - 4 * kLargestDefect - 0x1p-31 / kClearCorner - 0x1p-20);

/// A feature of one polygon: a vertex, or an edge whose ends are `first` and `last`; and the axis that it faces along.
class Facing {
 public:
  /// n leads away from the other polygon.
  [[gnu::always_inline]] Facing(const ConvexRing& ring, const Pose& pose, std::uint32_t first, bool is_edge, Double2 n)
      : ring_(ring), first_(first), last_(is_edge ? ring_.next(first) : first), before_(ring_.previous(first)) {
    const double* r = pose.data();  // columns of three
    const Double2 first_column{r[0], r[1]}, second_column{r[3], r[4]};
    axis_ = Double2{dot(first_column, n), dot(second_column, n)};
  }

  /// The lesser one of how far the neighbours are behind; negative unless both are clearly so, see kLeastSlope. No edge
  /// is longer than `longest`.
  [[gnu::always_inline]] double depth(double distance, double longest) const {
    const Double2 before = -ring_.edge(before_), after = ring_.edge(last_);
    const double h1 = dot(axis_, before), h2 = dot(axis_, after), least = std::min(h1, h2);
    constexpr double kSlopeSquare = kLeastSlope * kLeastSlope;
    const bool is_clear = least > kLeastDepth * distance &&
                          (least > kLeastSlope * longest || (h1 * h1 > kSlopeSquare * dot(before, before) &&
                                                             h2 * h2 > kSlopeSquare * dot(after, after)));
    return is_clear ? least : -1;
  }

  /// A neighbour that is ahead, and the edge that leads there; false if none is.
  bool isBehind(std::uint32_t& vertex, std::uint32_t& edge) const {
    const double h1 = -dot(axis_, ring_.edge(before_)), h2 = dot(axis_, ring_.edge(last_));
    vertex = h1 < h2 ? before_ : ring_.next(last_);
    edge = h1 < h2 ? before_ : last_;
    return std::min(h1, h2) < 0;
  }

  /// The edges that have a vertex less than `near` behind. False if there are many or one is ahead.
  bool edgesNear(double near, RingRange& edges) const {
    std::uint32_t begin = first_, end = last_;
    const auto isNear = [&](std::uint32_t v, bool& is_ahead) {
      const double height = dot(axis_, ring_.way(first_, v));
      is_ahead = !(height > -0.25 * near);
      return !(height > near);
    };
    bool is_ahead = false;
    int found = 0;
    for (std::uint32_t v = ring_.previous(begin); isNear(v, is_ahead); v = ring_.previous(v), ++found)
      if (begin = v; is_ahead || found == kMostNear) return false;
    for (std::uint32_t v = ring_.next(end); isNear(v, is_ahead); v = ring_.next(v), ++found)
      if (end = v; is_ahead || found == kMostNear) return false;
    edges.first = ring_.previous(begin);
    edges.count = std::min(ring_.size(), (end < edges.first ? end + ring_.size() : end) - edges.first + 1);
    return true;
  }

 private:
  const ConvexRing& ring_;
  std::uint32_t first_, last_, before_;
  Double2 axis_;
};

class FeatureSearch {
 public:
  FeatureSearch(const PosedVertices& vertices, NearestFeatures& found)
      : vertices_(vertices), a_(ringOf(vertices.a)), b_(ringOf(vertices.b)), found_(found) {}

  /// Whether these are the nearest features, or those that they lead to by a neighbour. After a jump, further steps
  /// would cost what the cache saves.
  bool proveOrNext(const FeaturePair& features) { return prove(features) || prove(FeaturePair(ahead_)); }

  bool prove(const ConvexGap& guess) {
    return guess.of_a ? proveBeside<true>(guess.edge, guess.vertex) : proveBeside<false>(guess.edge, guess.vertex);
  }

  bool prove(const FeaturePair& features) {
    switch (features.kind) {
      case FeaturePair::kEdgeOfA:
        return proveBeside<true>(features.edge_a, features.edge_b);
      case FeaturePair::kEdgeOfB:
        return proveBeside<false>(features.edge_b, features.edge_a);
      case FeaturePair::kVertices:
        return proveVertices(features.edge_a, features.edge_b,
                             vertices_.betweenVertices(features.edge_a, features.edge_b));
      default:
        return false;
    }
  }

 private:
  /// Whether edge e of one and vertex v of the other, or an end of that edge, are the nearest features.
  template <bool kEdgeOfA>
  bool proveBeside(std::uint32_t e, std::uint32_t v) {
    const Foot foot = vertices_.foot<kEdgeOfA>(e, v);
    if (!(foot.inside > 0)) {
      const std::uint32_t end = !foot.at_end ? e : (kEdgeOfA ? a_ : b_).next(e);
      return proveVertices(kEdgeOfA ? end : v, kEdgeOfA ? v : end, foot);
    }
    const double size = vertices_.size();
    const bool is_inside = foot.inside >= kInside * foot.distance * foot.length &&
                           (foot.is_plain || foot.inside > kClearProduct * size * size);
    constexpr auto kKind = kEdgeOfA ? FeaturePair::kEdgeOfA : FeaturePair::kEdgeOfB;
    return proveSupports<kKind>(kEdgeOfA ? e : v, kEdgeOfA ? v : e, foot, is_inside);
  }

  bool proveVertices(std::uint32_t v, std::uint32_t w, const Foot& foot) {
    const bool is_clear = foot.is_plain || foot.distance > kClear * vertices_.size();
    return proveSupports<FeaturePair::kVertices>(v, w, is_clear ? foot : vertices_.twofoldBetween(v, w), true);
  }

  /// Whether these are the support features, and the polygons are apart; and if they `may_be_unique`, whether they are.
  template <FeaturePair::Kind kKind>
  [[gnu::always_inline]] bool proveSupports(EdgePosition edge_a, EdgePosition edge_b, const Foot& foot,
                                            bool may_be_unique) {
    constexpr bool kVertices = kKind == FeaturePair::kVertices;
    const FeaturePair features{kKind, edge_a, edge_b};
    const double distance = foot.distance, size = vertices_.size();
    const double depth = std::min(depthOf<true, kKind == FeaturePair::kEdgeOfA>(features, foot),
                                  depthOf<false, kKind == FeaturePair::kEdgeOfB>(features, foot));
    const bool is_clear =
        foot.is_plain || (kVertices ? distance * depth > kClearProduct * size * size : distance > kSide * size);
    found_.is_unique = may_be_unique && depth > 0 && is_clear;
    if (!found_.is_unique && !proveByNeighbours(features, foot)) return false;
    found_.are_apart = true;
    found_.features = features;
    found_.foot = foot;
    return true;
  }

  [[gnu::always_inline]] Facing facingOfA(const FeaturePair& features, const Foot& foot) const {
    return {a_, vertices_.pose_a, features.edge_a, features.kind == FeaturePair::kEdgeOfA, -foot.axis};
  }
  [[gnu::always_inline]] Facing facingOfB(const FeaturePair& features, const Foot& foot) const {
    return {b_, vertices_.pose_b, features.edge_b, features.kind == FeaturePair::kEdgeOfB, foot.axis};
  }

  /// Of a vertex that is outside of the line along an edge, the polygon is behind that, and edge_depth tells how far.
  /// Rounding may hide on which side it is only where foot.distance isn't clear.
  template <bool kOfA, bool kIsEdge>
  [[gnu::always_inline]] double depthOf(const FeaturePair& features, const Foot& foot) const {
    const PolygonData& polygon = kOfA ? vertices_.a : vertices_.b;
    if (kIsEdge) {
      const Convexity& convexity = convexityOf(polygon);
      const double known = kKept * convexity.edge_depth;
      const bool has_left = (convexity.direction > 0) == (kOfA ? vertices_.keepsHandOfA() : vertices_.keepsHandOfB());
      if (known > kLeastDepth * foot.distance && foot.is_left != has_left) return known;
    }
    return (kOfA ? facingOfA(features, foot) : facingOfB(features, foot)).depth(foot.distance, 2.1 * polygon.radius);
  }

  /// Whether edges near these hold the distance, if any do.
  [[gnu::noinline]] bool proveByNeighbours(const FeaturePair& features, const Foot& foot) {
    const Facing of_a = facingOfA(features, foot), of_b = facingOfB(features, foot);
    const double size = vertices_.size();
    if (foot.distance > kSure * size && of_a.edgesNear(kNear * size, found_.edges_a) &&
        of_b.edgesNear(kNear * size, found_.edges_b))
      return true;
    lookAhead(features, of_a, of_b);
    return false;
  }

  /// Features that are nearer than these, since a neighbour is.
  void lookAhead(const FeaturePair& features, const Facing& of_a, const Facing& of_b) {
    const bool are_vertices = features.kind == FeaturePair::kVertices;
    std::uint32_t vertex, edge;
    if (features.kind != FeaturePair::kEdgeOfA && of_a.isBehind(vertex, edge))
      ahead_ = {are_vertices ? FeaturePair::kEdgeOfA : FeaturePair::kEdgeOfB, are_vertices ? edge : vertex,
                features.edge_b};
    else if (features.kind != FeaturePair::kEdgeOfB && of_b.isBehind(vertex, edge))
      ahead_ = {are_vertices ? FeaturePair::kEdgeOfB : FeaturePair::kEdgeOfA, features.edge_a,
                are_vertices ? edge : vertex};
  }

  /// Which way it runs isn't asked.
  static ConvexRing ringOf(const PolygonData& polygon) { return {polygon.path.data(), polygon.path.size() - 1, 0}; }

  const PosedVertices& vertices_;
  const ConvexRing a_, b_;
  NearestFeatures& found_;
  FeaturePair ahead_;  ///< of features that weren't proven
};

FeaturePair nearestByWalk(const PosedVertices& vertices) {
  return walkToNearest({convexRing(vertices.a), vertices.pose_a}, {convexRing(vertices.b), vertices.pose_b},
                       vertices.way(), [&](std::uint32_t v, std::uint32_t w) { return vertices.way(v, w); });
}

bool innerDiscsMeet(const PosedVertices& vertices) {
  const InnerDiscs *a = innerDiscsIfPaid(vertices.a), *b = innerDiscsIfPaid(vertices.b);
  if (a == nullptr || b == nullptr) return false;
  const double reach = a->largest + b->largest;
  const Double2 way = vertices.way(a->center, b->center);
  return dot(way, way) < reach * reach;
}

}  // namespace

NearestFeatures findNearestFeatures(const PosedVertices& vertices, const FeaturePair& tried) {
  NearestFeatures found;
  if (!vertices.isUnscaled()) return found;
  if (tried.kind != FeaturePair::kNone) found.were_tried = FeatureSearch(vertices, found).proveOrNext(tried);
  if (found.were_tried) return found;
  const bool discs_meet = innerDiscsMeet(vertices);
  const SmallPolygon *a = topOf(vertices.a).small_convex, *b = topOf(vertices.b).small_convex;
  if (a == nullptr || b == nullptr) {
    found.seem_to_meet = discs_meet || !FeatureSearch(vertices, found).prove(nearestByWalk(vertices));
    return found;
  }
  const UnitMap at = vertices.inUnits(vertices.defect);
  if (!discs_meet) {
    const ConvexGap guess = convexGap(*a, *b, at);
    if (guess.gap > -kFloatDoubt) {
      FeatureSearch search(vertices, found);
      // The walk makes the answer independent of whether discs have been built.
      if (search.prove(guess) || (guess.gap > 0 && search.prove(nearestByWalk(vertices)))) return found;
    }
  }
  found.seem_to_meet = true;
  if (std::abs(at.tx) + std::abs(at.ty) < 4) found.crossing = convexCrossing(*a, *b, at);
  return found;
}

}  // namespace tricover::detail
