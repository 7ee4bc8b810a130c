// SPDX-License-Identifier: BSD-3-Clause
#include "penetration/penetration.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "convex/convex_outline.h"
#include "distance/distance_result.h"
#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "numbers/segment.h"
#include "overlay/interiors.h"
#include "pair/collide_by_hierarchy.h"
#include "pair/kernel_order.h"
#include "penetration/separating_axes.h"
#include "penetration/translation_search.h"
#include "polygon/cache_access.h"
#include "polygon/edge_walk.h"

namespace tricover {
namespace detail {
namespace {

/// Where an edge and a vertex part last, by side (0: a, 1: b).
struct Features {
  Vec2 points[2];         ///< in the space's units
  Vec2 normal;            ///< unit
  EdgePosition edges[2];  ///< what they are on, or near it
};

/// After the translation t: an edge of `side`, from one vertex to another, straight on where several are between these,
/// and a vertex of the other. The vertex may come beyond the edge's end only where an edge at it is parallel: that one
/// is taken.
Features featuresOf(const TranslationSpace& space, const Vec2& t, int side, EdgePosition edge, std::size_t start,
                    std::size_t end, EdgePosition vertex) {
  const int other = 1 - side;
  const Vec2 v = space.side(side).vertex(start), w = space.side(side).vertex(end), by = side == 0 ? t : Vec2(-t);
  const Vec2 p = nearestOnSegment(space.side(other).vertex(vertex) + by, v, w);
  const auto endsOf = [&](EdgePosition e) {
    return Ends{space.side(other).vertex(e), space.side(other).vertex(e + 1)};
  };
  const Vec2 across(v.y() - w.y(), w.x() - v.x());
  Features features{{p, p}, t.normalized(), {edge, edge}};
  features.points[other] -= by;
  features.edges[other] = flatterEdge(edgesAt(space.side(other).polygon, vertex), across, endsOf);
  return features;
}

/// Of convex regions. Edges beside the least face may be parallel to it but for rounding, and the corner behind it be
/// beside one of those.
Features featuresOf(const TranslationSpace& space, const PosedPair& pair, const SupportGap& gap) {
  const int side = gap.of_a ? 0 : 1, other = 1 - side;
  const PolygonData& own = space.side(side).polygon;
  const ConvexOutline& outline = convexOutlineOf(own);
  const EdgePosition corner = convexOutlineOf(space.side(other).polygon).corners[gap.deepest];
  const std::size_t count = outline.corners.size();
  const PosedPair seen = side == 0 ? pair : pair.back();
  const ApproxPoint deepest = seenFromA(seen, space.side(other).polygon.path[corner]).approx;
  const Vec2 t = gap.normal * (gap.depth / space.frame.unit()), vertex = space.side(other).vertex(corner);
  const auto at = [&](std::size_t k) {
    return featuresOf(space, t, side, pathEdge(own, outline, k, {deepest.x, deepest.y}), outline.corners[k],
                      outline.corners[(k + 1) % count], corner);
  };
  const auto off = [&](const Features& f) { return (f.points[other] - vertex).norm(); };
  const double on = 64 * space.noise();
  for (std::size_t k = 0; k < count; ++k) {
    const Features beside = at((gap.edge + k) % count);
    if (off(beside) <= on) return beside;
  }
  return at(gap.edge);
}

/// The same for what the search found, by the convolution segment that is nearest to its limit: it is on one, unless
/// it ended early.
Features featuresOf(const TranslationSpace& space, const ShortestParting& shortest) {
  const Vec2 t = shortest.limit;
  const double noise = space.noise();
  const auto& [nearest, apart] = shortest.nearest;
  const bool is_on = apart <= 64 * noise;
  const EdgePosition edge = nearest.vertex_of_a ? nearest.edge_b : nearest.edge_a,
                     vertex = nearest.vertex_of_a ? nearest.edge_a : nearest.edge_b;
  Features features = featuresOf(space, is_on ? t : nearestOnSegment(t, nearest.v, nearest.w), nearest.vertex_of_a,
                                 edge, edge, edge + 1, vertex);
  const Vec2 way = t.norm() > noise ? t : shortest.parting, along = nearest.w - nearest.v;
  features.normal = way.stableNormalized();
  // Over a short way the segment's normal is known better than the way's direction.
  if (along.norm() > 0 && is_on && std::abs(t.dot(along)) <= 4 * noise * along.norm()) {
    features.normal = Vec2(along.y(), -along.x()).stableNormalized();
    if (features.normal.dot(way) < 0) features.normal = -features.normal;
  }
  return features;
}

/// The number of the edge that a feature's point is on: the expected one, or else the nearest.
EdgeIndex edgeAt(const TranslationSpace& space, const Features& features, int side) {
  const PolygonData& polygon = space.side(side).polygon;
  const double error = 4 * space.noise();
  EdgePosition nearest = features.edges[side];
  const auto distanceTo = [&](EdgePosition e) {
    return squaredDistanceToSegment(features.points[side], space.side(side).vertex(e), space.side(side).vertex(e + 1));
  };
  double least = distanceTo(nearest);
  for (std::size_t r = 0; r < polygon.ringCount() && !(least <= error * error); ++r)
    for (EdgePosition e = polygon.edgeBegin(r); e < polygon.edgeEnd(r); ++e) {
      const double square = distanceTo(e);
      if (!(square < least)) continue;
      least = square;
      nearest = e;
    }
  return polygon.edgeNumber(nearest);
}

/// Where lengths overflow.
Penetration noAnswer(const Vec2& normal) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return {kInfinity, normal, 0, false, Vec2::Zero(), Vec2::Zero(), Vec2::Zero(), -1, -1};
}

/// Finds a translation that is proven to separate the regions by more than the margin. Tries limit + step * way, and
/// doubles the step until that is longer than `longest`. Either region may be translated: both poses' translations are
/// rounded.
bool findTranslation(const PosedPair& pair, const Vec2& limit, const Vec2& way, double step, double margin,
                     Penetration& result, double longest = std::numeric_limits<double>::infinity()) {
  do {
    const Vec2 t = limit + step * way;
    if (areApartMoved(pair, Vec2::Zero(), t, margin) && areApartMoved(pair, -t, Vec2::Zero(), margin)) {
      result.translation = t;
      return true;
    }
    step *= 2;
  } while (std::isfinite(step) && (limit + step * way).stableNorm() <= longest);
  return false;
}

/// Of regions that are apart, and within the margin.
Penetration nearestWithout(const PosedPair& pair) {
  const auto [nearest, normal] = nearestContact(pair);
  return {-nearest.distance, normal,          -nearest.distance, true,          Vec2::Zero(),
          nearest.point_a,   nearest.point_b, nearest.edge_a,    nearest.edge_b};
}

/// With a margin, from the shortest translation without one, whose depth is negative where the regions are apart. The
/// shortest with a margin is longer by the margin at least: back by the margin from its end there is one without. If
/// the regions are within the margin straight on, it goes on until they are not, and at last as far as the hulls
/// require.
Penetration straightOn(const PosedPair& pair, Penetration p, const SupportGap& hulls, double margin, bool are_convex) {
  const double size = pair.a.radius + pair.b.radius + margin, step = 64 * kUnitRoundoff * size + kTiny;
  p.depth = std::max(p.depth + margin, 0.0);
  p.lower_bound = std::max(p.lower_bound + margin, 0.0);
  const double longest = are_convex ? std::numeric_limits<double>::infinity() : p.depth + 1e-13 * size;
  if (findTranslation(pair, p.depth * p.normal, p.normal, step, margin, p, longest)) return p;
  if (are_convex) return noAnswer(p.normal);
  p.optimal = false;
  const double least = p.depth, most = hulls.depth + margin;
  if (!findTranslation(pair, least * p.normal, p.normal, std::max(step, margin / 16), margin, p, most)) {
    p.normal = hulls.normal;
    if (!findTranslation(pair, most * p.normal, p.normal, step, margin, p)) return noAnswer(p.normal);
  }
  p.depth = std::max(least, p.translation.stableNorm());
  return p;
}

}  // namespace

/// Beside the inner of an edge the normal is the edge's, which is known better than the way between points that are
/// near. Where that is nothing but rounding, b's S tells the side.
NearestContact nearestContact(const PosedPair& pair, const DistanceQuery& query) {
  const DistanceResult nearest = distanceInOrder(PosedVertices(pair), query);
  const WorldFrame frame(pair);
  const WorldFrame::Ends edge_a = frame.edgeEndsOfA(pair.a.edgePosition(nearest.edge_a)),
                         edge_b = frame.edgeEndsOfB(pair.b.edgePosition(nearest.edge_b));
  const double error = 4 * frame.error();
  // An end and the inner of an edge may be as near but for rounding: those count that distance() names.
  NearestPlaces at = nearestPlaces(edge_a, edge_b);
  const Vec2 named_a = frame.fromWorld(nearest.point_a), named_b = frame.fromWorld(nearest.point_b);
  double off = std::numeric_limits<double>::infinity();
  const double reach = at.way().norm() + error;
  forEachNearest(edge_a, edge_b, [&](const NearestPlaces& places) {
    const double other = (places.on_a - named_a).squaredNorm() + (places.on_b - named_b).squaredNorm();
    if (places.way().norm() <= reach && other < off) off = other, at = places;
  });
  const Vec2 side = at.way().norm() > error ? at.way() : Vec2(-frame.originOfA());
  const auto across = [&](const WorldFrame::Ends& edge) {
    const Vec2 normal = Vec2(edge.v.y() - edge.w.y(), edge.w.x() - edge.v.x()).stableNormalized();
    return normal.dot(side) < 0 ? Vec2(-normal) : normal;
  };
  const auto isInner = [&](const Vec2& p, const WorldFrame::Ends& edge) {
    return (p - edge.v).norm() > error && (p - edge.w).norm() > error;
  };
  if (isInner(at.on_a, edge_a)) return {nearest, across(edge_a)};
  if (isInner(at.on_b, edge_b)) return {nearest, across(edge_b)};
  return {nearest, side.isZero(0) ? Vec2(Vec2::UnitX()) : Vec2(side.stableNormalized())};
}

bool areApartMoved(const PosedPair& pair, const Vec2& by_a, const Vec2& by_b, double margin) {
  Pose pose_a = pair.pose_a, pose_b = pair.pose_b;
  pose_a.translation() += by_a;
  pose_b.translation() += by_b;
  return pose_a.translation().allFinite() && pose_b.translation().allFinite() &&
         !collideByHierarchy(PosedPair(pair.a, pose_a, pair.b, pose_b), {margin, 0}, 0, Wanted::Answer).collides;
}

Penetration penetrationInOrder(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                               double margin, std::size_t most, PenetrationHint* hint) {
  const ConvexOutline &outline_a = convexOutlineOf(a), &outline_b = convexOutlineOf(b);
  const PosedPair pair(a, pose_a, b, pose_b);
  const bool are_convex = outline_a.is_region && outline_b.is_region;
  std::optional<SeparatingAxes> axes;
  if (outline_a.corners.size() > 2 && outline_b.corners.size() > 2) axes.emplace(pair);
  const SupportGap gap = leastSupportGap(pair, axes ? &*axes : nullptr, 0);
  if (margin > 0) {
    const bool are_apart = areApartMoved(pair, Vec2::Zero(), Vec2::Zero(), 0);
    return straightOn(pair, are_apart ? nearestWithout(pair) : penetrationInOrder(a, pose_a, b, pose_b, 0, most, hint),
                      gap, margin, are_convex);
  }
  TranslationSpace space(pair);
  if (!space.isFinite()) return noAnswer(gap.normal);
  Penetration result{gap.depth, gap.normal, 0, false, Vec2::Zero(), Vec2::Zero(), Vec2::Zero(), 0, 0};
  const double unit = space.frame.unit();
  const Vec2 known = gap.normal * (gap.depth / unit);
  ShortestParting shortest{known, known, known.norm(), {}};
  Features features;
  if (are_convex) {
    features = featuresOf(space, pair, gap);
    result.lower_bound = result.depth;
    result.optimal = true;
  } else {
    // Where b's S is in a's frame after the translation.
    Vec2 last;
    if (hint != nullptr) last = pose_a.linear() * Vec2(hint->end[0], hint->end[1]) / unit + space.frame.originOfA();
    shortest = searchShortestParting(space, known, hint != nullptr ? &last : nullptr, most);
    if (hint != nullptr) {
      const Vec2 end = pose_a.linear().inverse() * ((shortest.parting - space.frame.originOfA()) * unit);
      std::copy(end.begin(), end.end(), hint->end);
    }
    features = featuresOf(space, shortest);
    if (shortest.limit != known) {
      const double length = shortest.limit.norm();
      result.depth = length > 2 * space.noise() ? length * unit : 0;
      result.normal = features.normal;
    }
    result.lower_bound = std::min(shortest.lower_bound * unit, result.depth);
    // What tricover/penetration.h calls the precision.
    const double between = (pose_b.translation() / unit - pose_a.translation() / unit).norm();
    const double size = a.radius / unit + b.radius / unit + between;
    const double precision = std::max(32 * space.noise(), 1e-13 * size);
    result.optimal = result.depth - result.lower_bound <= 1e-12 * std::min(a.radius, b.radius) + precision * unit;
  }
  const Vec2 aside = shortest.parting - shortest.limit;
  const Vec2 way = !aside.isZero(0) ? Vec2(aside.stableNormalized()) : result.normal;
  // Where they just touch no filter would tell that they are apart, and exact signs cost more than all the rest.
  if (!findTranslation(pair, shortest.limit * unit, way, 8 * space.noise() * unit, 0, result))
    return noAnswer(result.normal);
  // Where lines cross at a small angle their crossing isn't known to the precision: what is proven to part them is.
  if (!result.optimal) result.depth = std::max(result.depth, result.translation.stableNorm());
  result.point_a = space.frame.toWorld(features.points[0]);
  result.point_b = space.frame.toWorld(features.points[1]);
  result.edge_a = edgeAt(space, features, 0);
  result.edge_b = edgeAt(space, features, 1);
  assert(std::abs(result.normal.norm() - 1) < 0x1p-40);
  assert(0 <= result.lower_bound && result.lower_bound <= result.depth);
  return result;
}

namespace {

std::optional<Penetration> penetration(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                                       PairCacheContents* cache, const PenetrationOptions& options) {
  requireFiniteNotNegative(options.margin, "margin");
  requireBounded(a, b);
  requireTouching(options.touching);
  const double defect = requireRigid(pose_a, pose_b);
  if (!regionsCollide(detail::dataOf(a), pose_a, detail::dataOf(b), pose_b, defect, nullptr,
                      {options.margin, 0, options.touching}))
    return std::nullopt;
  return inKernelOrder(
      detail::dataOf(a), pose_a, detail::dataOf(b), pose_b,
      [&](const auto&... operands) {
        return penetrationInOrder(operands..., options.margin, kMostTranslations,
                                  cache != nullptr ? &cache->penetration : nullptr);
      },
      [](Penetration& p) {
        p.normal = -p.normal;
        p.translation = -p.translation;
        std::swap(p.point_a, p.point_b);
        std::swap(p.edge_a, p.edge_b);
      });
}

}  // namespace
}  // namespace detail

std::optional<Penetration> penetration(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                                       const PenetrationOptions& options) {
  return detail::penetration(a, pose_a, b, pose_b, nullptr, options);
}

std::optional<Penetration> penetration(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                                       PairCache& cache, const PenetrationOptions& options) {
  return detail::penetration(a, pose_a, b, pose_b, &detail::contentsOf(cache), options);
}

}  // namespace tricover
