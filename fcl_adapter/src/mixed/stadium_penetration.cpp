// SPDX-License-Identifier: BSD-3-Clause
#include "mixed/stadium_penetration.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tricover/collide.h"

namespace tricover_fcl {
namespace {

using tricover::Pose;
using tricover::Vec2;

/// Of the radius: what a way may leave of an overlap, and how near a centre counts as on an edge, whose normal is then
/// the direction.
constexpr double kError = 1e-9;

template <typename S>
bool isFreeAfter(const StadiumPair<S>& pair, const StadiumPenetration& way) {
  Pose there = pair.pose_b;
  there.translation() += way.depth * way.normal;
  tricover::CollideOptions options;
  options.margin = (1 - kError) * pair.radius;
  return !tricover::collide(*pair.a, pair.pose_a, *pair.b, there, options);
}

struct NearestEdge {
  std::ptrdiff_t edge;
  Vec2 point, along;
};

/// Of the polygon's outline to `center`, in the plane. Squares are of a length in which the polygon is of size 1, so
/// that they neither overflow nor vanish.
NearestEdge nearestEdge(const tricover::Polygon& polygon, const Pose& pose, const Vec2& center) {
  NearestEdge nearest{-1, Vec2::Zero(), Vec2::Zero()};
  double least = std::numeric_limits<double>::infinity();
  const double scale = std::ldexp(1, -std::clamp(std::ilogb(polygon.radius()), -1000, 1000));
  for (tricover::EdgeIndex i = 0, count = static_cast<tricover::EdgeIndex>(polygon.vertexCount()); i < count; ++i) {
    const Vec2 v = pose * polygon.edgeStart(i), along = pose * polygon.edgeEnd(i) - v, unit = scale * along;
    const double part = std::clamp(unit.dot(scale * (center - v)) / unit.squaredNorm(), 0.0, 1.0);
    const Vec2 point = v + (part == part ? part : 0) * along;
    const double square = (scale * (point - center)).squaredNorm();
    if (square < least) {
      least = square;
      nearest = {i, point, along};
    }
  }
  return nearest;
}

/// Of a disc whose centre isn't outside of the polygon: across the nearest edge.
template <typename S>
std::optional<StadiumPenetration> acrossNearestEdge(const StadiumPair<S>& pair) {
  const Vec2 center = pair.pose_b.translation();
  const NearestEdge nearest = nearestEdge(*pair.a, pair.pose_a, center);
  const Vec2 out = nearest.point - center;
  const double length = out.stableNorm();
  StadiumPenetration way{out / length, pair.radius + length, nearest.point, nearest.edge};
  if (length > kError * pair.radius) return isFreeAfter(pair, way) ? std::optional(way) : std::nullopt;
  const Vec2 normal = Vec2(nearest.along.y(), -nearest.along.x()).stableNormalized();
  for (const Vec2& direction : {normal, Vec2(-normal)}) {
    way.normal = direction;
    if (isFreeAfter(pair, way)) return way;
  }
  return std::nullopt;
}

}  // namespace

/// Moving by t, a stadium comes no farther than |t| from where it was: from a distance d to that of the radius r, which
/// is where it is free, by no less than r - d; from where its segment meets the polygon, by no less than what parts the
/// segment, p, and r from there. So a way of the length r - d or r + p is the shortest if it leads to where the stadium
/// is free.
template <typename S>
std::optional<StadiumPenetration> penetrationOf(const StadiumPair<S>& pair) {
  const tricover::DistanceResult apart = pair.distance();
  if (apart.distance > kError * pair.radius) {
    const StadiumPenetration way{(apart.point_b - apart.point_a).stableNormalized(), pair.radius - apart.distance,
                                 apart.point_a, apart.edge_a};
    return way.depth <= 0 || isFreeAfter(pair, way) ? std::optional(way) : std::nullopt;
  }
  if (pair.isDisc()) return acrossNearestEdge(pair);
  const auto part = pair.penetration();
  if (!part) return std::nullopt;
  const StadiumPenetration way{part->normal, pair.radius + part->depth, part->point_a, part->edge_a};
  return isFreeAfter(pair, way) ? std::optional(way) : std::nullopt;
}

template std::optional<StadiumPenetration> penetrationOf(const StadiumPair<float>&);
template std::optional<StadiumPenetration> penetrationOf(const StadiumPair<double>&);

}  // namespace tricover_fcl
