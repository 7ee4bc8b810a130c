// SPDX-License-Identifier: BSD-3-Clause
#include "distance/convex_nearest.h"

#include <algorithm>
#include <cmath>

#include "convex/convex_ring.h"
#include "hierarchy/simd.h"
#include "pair/placement.h"

namespace tricover::detail {
namespace {

// Let v in a and w in b be vertices of features that are guessed to be the nearest, d their distance and n the axis
// between them, from a to b. Heights are along n, and a convex ring falls from its highest vertex to its lowest one on
// either side: who knows both neighbours of a feature knows all vertices.
//
// kNear of the size is more than rounding: n leads along w - v but for an angle of 2^-23 where d is kSure of the size;
// heights are off by 16U of it, d by 64U. Where no neighbour is ahead by kNear / 4, and those up to kNear behind are
// near as well, edges without a near vertex are farther apart than d by kNear / 2 at least.
constexpr double kNear = 0x1p-40, kSure = 0x1p-27;
static_assert(kNear / 4 >= 0x1p-46 + 2 * (16 + 64) * kUnitRoundoff);

// The features alone hold the distance where
//   their neighbours are behind by kLeastDepth of d, and by kLeastSlope of the way there;
//   the foot beside an edge is kInside of d or more from its ends.
// Any other two edges then have points x and y, a height of kLeastDepth d more between them; or x is aside from the
// foot by kInside d, and so is y by half of that, which adds kLeastSlope to the height, or y isn't, and the way is a
// slant one: by a share of kInside^2 / 8. EdgeDistances is right to 2^-47, no matter which of them it evaluates. In the
// slopes n may be wrong by 2^-31: where `d` isn't plain, it is kClear of the size.
constexpr double kLeastDepth = 0x1p-38, kLeastSlope = 0x1p-20, kInside = 0x1p-18, kClear = 0x1p-18;
constexpr double kLeastShare = 0x1p-40;
static_assert(kLeastDepth > kLeastShare && kInside * kLeastSlope / 2 > kLeastShare &&
              kInside * kInside / 8 > kLeastShare && kLeastShare > 4 * EdgeDistances::kRelativeError);

// Where d isn't plain, EdgeDistances is certain of where the foot is: products of lengths are above what it is unsure
// of.
constexpr double kClearProduct = 0x1p-43;

constexpr int kMostNear = 8;
/// To features that others lead to: more would cost after a jump what the cache saves.
constexpr int kMostSteps = 2;

/// A feature of one polygon: a vertex, or an edge whose ends are `first` and `last`; and the axis that it faces along.
class Facing {
 public:
  /// n leads away from the other polygon.
  Facing(const PolygonData& polygon, const Pose& pose, std::uint32_t first, bool is_edge, Double2 n)
      : ring_(polygon.path.data(), polygon.path.size() - 1, hierarchyOf(polygon).convex),
        first_(first),
        last_(is_edge ? ring_.next(first) : first) {
    const double* r = pose.data();  // columns of three
    const Double2 first_column{r[0], r[1]}, second_column{r[3], r[4]};
    axis_ = Double2{dot(first_column, n), dot(second_column, n)};
  }

  /// The lesser one of how far the neighbours are behind; negative unless both are clearly so, see kLeastSlope.
  double depth(double distance) const {
    const Double2 before = ring_.way(first_, ring_.previous(first_)), after = ring_.way(last_, ring_.next(last_));
    const double h1 = dot(axis_, before), h2 = dot(axis_, after), least = std::min(h1, h2);
    constexpr double kSlopeSquare = kLeastSlope * kLeastSlope;
    const bool is_clear = least > kLeastDepth * distance && h1 * h1 > kSlopeSquare * dot(before, before) &&
                          h2 * h2 > kSlopeSquare * dot(after, after);
    return is_clear ? least : -1;
  }

  /// A neighbour that is ahead, and the edge that leads there; false if none is.
  bool isBehind(std::uint32_t& vertex, std::uint32_t& edge) const {
    const std::uint32_t before = ring_.previous(first_), after = ring_.next(last_);
    const double h1 = dot(axis_, ring_.way(first_, before)), h2 = dot(axis_, ring_.way(last_, after));
    vertex = h1 < h2 ? before : after;
    edge = h1 < h2 ? before : last_;
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
  ConvexRing ring_;
  std::uint32_t first_, last_;
  Double2 axis_;
};

class ConvexSearch {
 public:
  ConvexSearch(const PlainWays& ways, const DistanceOptions& options, ConvexNearest& found)
      : ways_(ways), options_(options), found_(found) {}

  void find(const ConvexFeatures& tried) {
    if (!ways_.isUnscaled()) return;
    found_.is_proven = provesOnWay(tried);
    if (!found_.is_proven) findAnew();
  }

 private:
  void findAnew() {
    const Hierarchy &a = hierarchyOf(ways_.a()), &b = hierarchyOf(ways_.b());
    const bool are_small = a.small_convex != nullptr && b.small_convex != nullptr;
    if (innerDiscsMeet(a, b)) {
      if (are_small) meet(*a.small_convex, *b.small_convex);
      return;
    }
    if (are_small) {
      const ConvexGap gap = convexGap(*a.small_convex, *b.small_convex, roughMap());
      if (!(gap.gap > 0)) return meet(*a.small_convex, *b.small_convex);
      const auto edge = static_cast<std::uint32_t>(gap.edge), vertex = static_cast<std::uint32_t>(gap.vertex);
      if (gap.of_a ? besideEdge<true>(edge, vertex) : besideEdge<false>(edge, vertex)) return;
    }
    proves(guessNearest(ways_));
  }

  /// Good enough to guess by: the inverse of a's pose is taken for its transpose.
  UnitMap roughMap() const {
    const double *ra = ways_.poseA().data(), *rb = ways_.poseB().data(), unit = ways_.a().inverse_unit;
    const Double2 x{ra[0], ra[3]}, y{ra[1], ra[4]};  // a's rows
    const Double2 m0 = x * rb[0] + y * rb[1], m1 = x * rb[3] + y * rb[4], way = ways_.betweenOrigins();
    const Double2 t = (x * way[0] + y * way[1]) * unit;
    return {m0[0], m1[0], m0[1], m1[1], t[0], t[1], ways_.b().unit * unit, 0};
  }

  /// As far as doubles see.
  bool innerDiscsMeet(const Hierarchy& a, const Hierarchy& b) const {
    const double reach = a.inner_radius + b.inner_radius;
    const Double2 way = ways_.wayBetween(a.inner_center, b.inner_center);
    return dot(way, way) < reach * reach;
  }

  void meet(const SmallPolygon& a, const SmallPolygon& b) {
    const PosedPair pair(ways_.a(), ways_.poseA(), ways_.b(), ways_.poseB());
    const UnitPlacement at(pair);
    if (!(std::abs(at.map.tx) + std::abs(at.map.ty) < 4)) return;
    const ConvexCrossing crossing = convexCrossing(a, b, at.map, at.rounding);
    if (crossing.edge_a >= 0 && crossing.edge_b >= 0) {
      const auto i = static_cast<std::uint32_t>(crossing.edge_a), j = static_cast<std::uint32_t>(crossing.edge_b);
      if (cross(i, j)) return;
      const EdgeDistances edges(ways_);
      if (edges.meet(i, j)) cross(i, j, edges.whereTheyMeet(edges.view(i, j)));
      return;
    }
    found_.inner_a = crossing.edge_a;
    found_.inner_b = crossing.edge_b;
    if (found_.isInside()) found_.meeting = Meeting::Meet;
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

  /// The same of features that these lead to by a few neighbours.
  bool provesOnWay(ConvexFeatures features) {
    for (int step = 0; step <= kMostSteps && features.kind != ConvexFeatures::kNone; ++step) {
      ahead_ = {};
      if (proves(features)) return true;
      features = ahead_;
    }
    return false;
  }

  bool proves(const ConvexFeatures& features) {
    switch (features.kind) {
      case ConvexFeatures::kEdgeOfA:
        return besideEdge<true>(features.edge_a, features.edge_b);
      case ConvexFeatures::kEdgeOfB:
        return besideEdge<false>(features.edge_b, features.edge_a);
      case ConvexFeatures::kVertices:
        return areNearest(features.edge_a, features.edge_b, ways_.startToStart(features.edge_a, features.edge_b));
      case ConvexFeatures::kCrossing:
        return cross(features.edge_a, features.edge_b);
      default:
        return false;
    }
  }

  /// Whether edge e of one and vertex v of the other, or an end of that edge, are the nearest features.
  template <bool kEdgeOfA>
  bool besideEdge(std::uint32_t e, std::uint32_t v) {
    const PlainWays::Foot foot = ways_.foot<kEdgeOfA>(e, v);
    if (!(foot.inside > 0)) {
      const std::size_t count = (kEdgeOfA ? ways_.a() : ways_.b()).path.size() - 1;
      const std::uint32_t end = !foot.at_end ? e : e + 1 == count ? 0 : e + 1;
      return areNearest(kEdgeOfA ? end : v, kEdgeOfA ? v : end, foot);
    }
    const double size = ways_.size();
    const bool is_inside = foot.inside >= kInside * foot.distance * foot.length &&
                           (foot.is_plain || foot.inside > kClearProduct * size * size);
    const std::uint32_t i = kEdgeOfA ? e : v, j = kEdgeOfA ? v : e;
    const ConvexFeatures features{kEdgeOfA ? ConvexFeatures::kEdgeOfA : ConvexFeatures::kEdgeOfB, i, j};
    if (!areForemost(features, foot, is_inside)) return false;
    if (!found_.is_unique) return true;
    if (foot.is_plain)
      found_.nearest = {foot.distance, kEdgeOfA ? foot.part() : 0, kEdgeOfA ? 0 : foot.part()};
    else
      found_.nearest = EdgeDistances(ways_).startBeside(kEdgeOfA, foot, i, j, options_);
    return true;
  }

  bool areNearest(std::uint32_t v, std::uint32_t w, const PlainWays::Foot& foot) {
    if (!areForemost({ConvexFeatures::kVertices, v, w}, foot, true)) return false;
    if (!found_.is_unique) return true;
    if (foot.is_plain)
      found_.nearest = {foot.distance, 0, 0};
    else
      found_.nearest = EdgeDistances(ways_).startAndStart(foot, v, w, options_);
    return true;
  }

  /// Whether these are foremost, and the polygons are apart; and if they `may_be_unique`, whether they are.
  bool areForemost(const ConvexFeatures& features, const PlainWays::Foot& foot, bool may_be_unique) {
    const Facing of_a(ways_.a(), ways_.poseA(), features.edge_a, features.kind == ConvexFeatures::kEdgeOfA, -foot.axis);
    const Facing of_b(ways_.b(), ways_.poseB(), features.edge_b, features.kind == ConvexFeatures::kEdgeOfB, foot.axis);
    const double distance = foot.distance, size = ways_.size();
    const double depth = std::min(of_a.depth(distance), of_b.depth(distance));
    const bool is_clear =
        foot.is_plain || (distance > kClear * size && (features.kind != ConvexFeatures::kVertices ||
                                                       distance * depth > kClearProduct * size * size));
    found_.is_unique = may_be_unique && depth > 0 && is_clear;
    if (!found_.is_unique && !(distance > kSure * size && of_a.edgesNear(kNear * size, found_.edges_a) &&
                               of_b.edgesNear(kNear * size, found_.edges_b))) {
      lookAhead(features, of_a, of_b);
      return false;
    }
    found_.features = features;
    found_.meeting = Meeting::Apart;
    return true;
  }

  /// Features that are nearer than these, since a neighbour is.
  void lookAhead(const ConvexFeatures& features, const Facing& of_a, const Facing& of_b) {
    std::uint32_t vertex, edge;
    if (features.kind != ConvexFeatures::kEdgeOfA && of_a.isBehind(vertex, edge)) {
      const bool are_vertices = features.kind == ConvexFeatures::kVertices;
      ahead_ = {are_vertices ? ConvexFeatures::kEdgeOfA : ConvexFeatures::kEdgeOfB, are_vertices ? edge : vertex,
                features.edge_b};
    } else if (features.kind != ConvexFeatures::kEdgeOfB && of_b.isBehind(vertex, edge)) {
      const bool are_vertices = features.kind == ConvexFeatures::kVertices;
      ahead_ = {are_vertices ? ConvexFeatures::kEdgeOfB : ConvexFeatures::kEdgeOfA, features.edge_a,
                are_vertices ? edge : vertex};
    }
  }

  const PlainWays& ways_;
  const DistanceOptions& options_;
  ConvexNearest& found_;
  ConvexFeatures ahead_;  ///< of features that weren't proven
};

}  // namespace

void nearestOfConvex(const PlainWays& ways, const ConvexFeatures& tried, const DistanceOptions& options,
                     ConvexNearest& found) {
  ConvexSearch(ways, options, found).find(tried);
}

}  // namespace tricover::detail
