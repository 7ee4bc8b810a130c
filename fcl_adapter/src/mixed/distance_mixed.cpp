// SPDX-License-Identifier: BSD-3-Clause
#include <fcl/narrowphase/contact.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mixed/mixed.h"
#include "mixed/mixed_pair.h"
#include "mixed/stadium_pair.h"
#include "shape/is_polygon.h"

namespace tricover_fcl {
namespace {

/// FCL calls collide about a negative distance, and insists on a depth that is a normal number.
template <typename S>
constexpr double kLeastDepth = static_cast<double>(std::numeric_limits<S>::min());

/// Points in the world: the first is on the polygon.
struct Span {
  double distance;
  Eigen::Vector3d point_a, point_b;
  std::ptrdiff_t edge_a, part_b;
};

/// Measures a geometry that reaches the polygon's heights. An overlap not deeper than the region's error is a touch,
/// but for surfaces if depths don't matter.
template <typename S>
Span measured(const MixedPair<S>& pair, const Shadow& shadow, tricover::DistanceResult found, bool is_signed) {
  const double margin = pair.shape.options().margin, touch = std::max(shadow.outlineError(), kLeastDepth<S>);
  const PlanarPair planar = pairOf(pair.polygon(), shadow, margin, margin);
  moveByMargins(planar, found);
  if (found.distance == 0 && !shadow.lift())
    found = overlapOf(planar, is_signed, shadow.isSurface(), shadow.outlineError(), kLeastDepth<S>, found);
  const Plane plane = pair.planeOf(shadow.heights().middle());
  const auto inWorld = [&](const tricover::Vec2& p) {
    return Eigen::Vector3d(plane * Eigen::Vector3d(p.x(), p.y(), 0));
  };
  Span span{found.distance, inWorld(found.point_a), inWorld(found.point_b), found.edge_a, shadow.partOf(found.edge_b)};
  const auto& lift = shadow.lift();
  if (found.distance > 0 || !lift || !(lift->depth > touch)) return span;
  span.distance = is_signed ? -lift->depth : -1;
  span.point_a = span.point_b = inWorld(pair.polygon().origin());
  if (std::isfinite(lift->depth)) span.point_b -= plane.linear() * (lift->depth * lift->normal);
  return span;
}

/// Measures a geometry above or below the polygon's heights as a prism: its whole shadow, between its lowest and its
/// highest point. Returns nothing for a geometry that has no point at all.
template <typename S>
std::optional<Span> measuredBeside(MixedPair<S> pair, double limit, const tricover::DistanceOptions& options) {
  const Slab slab = pair.view.slab;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  pair.view.slab = {-kInfinity, kInfinity};
  const std::optional<Shadow> shadow = makeShadow(pair.other, pair.view);
  if (!shadow) return std::nullopt;
  const bool is_above = shadow->heights().low > slab.high;
  const double height_a = is_above ? slab.high : slab.low,
               height_b = is_above ? shadow->heights().low : shadow->heights().high,
               apart = std::max(std::abs(height_b - height_a), std::numeric_limits<double>::denorm_min());
  if (apart >= limit) return std::nullopt;
  auto found = shadow->distance(pair.polygon(), limit, options);
  if (!found) return std::nullopt;
  moveByMargins(pairOf(pair.polygon(), *shadow, options.margin, options.margin), *found);
  const auto inWorld = [&](const tricover::Vec2& p, double height) {
    return Eigen::Vector3d(pair.from_polygon * Eigen::Vector3d(p.x(), p.y(), height));
  };
  if (found->distance == 0) found->point_b = found->point_a;
  return Span{std::hypot(found->distance, apart), inWorld(found->point_a, height_a), inWorld(found->point_b, height_b),
              found->edge_a, shadow->partOf(found->edge_b)};
}

/// Measures a disc or stadium. Returns nothing above the limit.
template <typename S>
std::optional<Span> measured(const StadiumPair<S>& pair, const fcl::DistanceRequest<S>& request, double limit) {
  auto found = pair.distanceWithin(limit, errorsOf(request));
  if (!found) return std::nullopt;
  moveByMargins(pair, *found);
  if (found->distance == 0) *found = overlapOf(pair, request.enable_signed_distance, false, 0, kLeastDepth<S>, *found);
  return Span{found->distance, pair.inWorld(found->point_a), pair.inWorld(found->point_b), found->edge_a,
              fcl::Contact<S>::NONE};
}

template <typename S>
std::optional<Span> measured(bool polygon_first, const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                             const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                             const fcl::DistanceRequest<S>& request, double limit) {
  const StadiumPair<S> round(polygon_first, o1, tf1, o2, tf2);
  if (round.found == StadiumCase::Pair) return measured(round, request, limit);

  const MixedPair<S> pair = mixedPair("distance", o1, tf1, o2, tf2);
  tricover::DistanceOptions options = errorsOf(request);
  options.margin = pair.shape.options().margin;
  std::optional<Shadow> shadow;
  if (round.found == StadiumCase::None) shadow = makeShadow(pair.other, pair.view);
  if (!shadow) return measuredBeside(pair, limit, options);
  const auto found = shadow->distance(pair.polygon(), limit, options);
  if (!found) return std::nullopt;
  return measured(pair, *shadow, *found, request.enable_signed_distance);
}

}  // namespace

template <typename S>
S distanceMixed(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1, const fcl::CollisionGeometry<S>& o2,
                const fcl::Transform3<S>& tf2, const fcl::DistanceRequest<S>& request, fcl::DistanceResult<S>& result) {
  if (request.isSatisfied(result)) return result.min_distance;
  const bool polygon_first = isPolygon(o1);
  const auto span = measured(polygon_first, o1, tf1, o2, tf2, request, static_cast<double>(result.min_distance));
  if (!span) return keepDistance(result);
  if (span->distance < 0) requireContactsIfSigned(o1, o2, request);
  if (polygon_first)
    updateDistance(o1, o2, span->distance, span->point_a, span->point_b, span->edge_a, span->part_b, result);
  else
    updateDistance(o1, o2, span->distance, span->point_b, span->point_a, span->part_b, span->edge_a, result);
  return result.min_distance;
}

template float distanceMixed(const fcl::CollisionGeometry<float>&, const fcl::Transform3<float>&,
                             const fcl::CollisionGeometry<float>&, const fcl::Transform3<float>&,
                             const fcl::DistanceRequest<float>&, fcl::DistanceResult<float>&);
template double distanceMixed(const fcl::CollisionGeometry<double>&, const fcl::Transform3<double>&,
                              const fcl::CollisionGeometry<double>&, const fcl::Transform3<double>&,
                              const fcl::DistanceRequest<double>&, fcl::DistanceResult<double>&);

}  // namespace tricover_fcl
