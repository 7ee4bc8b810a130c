// SPDX-License-Identifier: BSD-3-Clause
#include "mixed/distance_mixed.h"

#include <fcl/narrowphase/contact.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mixed/mixed_pair.h"
#include "mixed/stadium_pair.h"
#include "mixed/stadium_penetration.h"
#include "shape/fcl_results.h"
#include "shape/nearest_points.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"

namespace tricover_fcl {
namespace {

/// `a` is on the polygon.
struct Span {
  double distance;
  Eigen::Vector3d point_a, point_b;
  std::ptrdiff_t edge_a, part_b;
};

Eigen::Vector3d inSpace(const tricover::Vec2& p) { return {p.x(), p.y(), 0}; }

/// What is told of two that meet, in the polygon's frame. What isn't deeper than the outline errs is a touch, but for
/// surfaces if depths don't matter: FCL asks collide about a negative distance, and insists on a depth that is a normal
/// number.
template <typename S>
void measureOverlap(Span& span, const MixedPair<S>& pair, const Shadow& shadow, bool is_signed) {
  using tricover::Pose;
  const double touch = std::max(shadow.outlineError(), static_cast<double>(std::numeric_limits<S>::min()));
  if (const auto& lift = shadow.lift()) {
    if (!(lift->depth > touch)) return;
    span.distance = is_signed ? -lift->depth : -1;
    span.point_a = span.point_b = inSpace(pair.polygon().origin());
    if (std::isfinite(lift->depth)) span.point_b = span.point_a - lift->depth * lift->normal;
  } else if (is_signed) {
    const auto whole = shadow.penetration(pair.polygon());
    if (!whole || !(whole->depth > touch)) return;
    span = {-whole->depth, inSpace(whole->point_a), inSpace(whole->point_b), whole->edge_a,
            shadow.partOf(whole->edge_b)};
  } else {
    const auto overlaps = [&](const std::vector<tricover::Contact>& deepest) {
      return !deepest.empty() && deepest.front().depth > touch;
    };
    if ((shadow.isSurface() && shadow.meets(pair.polygon(), 0)) ||
        overlaps(tricover::contacts(pair.polygon(), Pose::Identity(), shadow.core(), Pose::Identity(), {0, 1})) ||
        overlaps(shadow.contacts(pair.polygon(), 1)))
      span.distance = -1;
  }
}

/// The options with what FCL asks for.
template <typename S>
tricover::DistanceOptions optionsOf(const fcl::DistanceRequest<S>& request, double margin) {
  tricover::DistanceOptions options;
  options.relative_error = static_cast<double>(request.rel_err);
  options.absolute_error = static_cast<double>(request.abs_err);
  options.margin = margin;
  return options;
}

/// Of a disc or stadium, in the world; false where a depth is asked for that has to be searched for. Nothing above the
/// limit is of interest.
template <typename S>
bool measured(Span& span, const StadiumPair<S>& pair, const fcl::DistanceRequest<S>& request, double limit) {
  const double margin = pair.shape.options().margin;
  const auto within = pair.distanceWithin(limit, optionsOf(request, pair.grown(margin)));
  if (!within) {
    span.distance = std::numeric_limits<double>::infinity();
    return true;
  }
  tricover::DistanceResult found = *within;
  span.distance = found.distance;
  span.edge_a = found.edge_a;
  span.part_b = fcl::Contact<S>::NONE;
  if (found.distance == 0) {
    // A touch is right to the error of a distance; margins don't overlap.
    tricover::CollideOptions deeper;
    deeper.margin = pair.radius * (1 - 1e-13) - static_cast<double>(std::numeric_limits<S>::min());
    if (deeper.margin >= 0 && tricover::collide(*pair.a, pair.pose_a, *pair.b, pair.pose_b, deeper)) {
      if (!request.enable_signed_distance) {
        span.distance = -1;
      } else if (const auto way = penetrationOf(pair); !way) {
        return false;
      } else if (way->depth > static_cast<double>(std::numeric_limits<S>::min())) {
        span = {-way->depth, pair.inWorld(way->point_a), pair.inWorld(way->point_b()), way->edge_a, span.part_b};
        return true;
      }
    }
  }
  moveByMargins(found, margin, pair.radius);
  span.point_a = pair.inWorld(found.point_a);
  span.point_b = pair.inWorld(found.point_b);
  return true;
}

}  // namespace

template <typename S>
S distanceMixed(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1, const fcl::CollisionGeometry<S>& o2,
                const fcl::Transform3<S>& tf2, const fcl::DistanceRequest<S>& request, fcl::DistanceResult<S>& result) {
  if (request.isSatisfied(result)) return result.min_distance;
  Span span;
  const auto report = [&](bool polygon_first) {
    if (polygon_first)
      updateDistance(o1, o2, span.distance, span.point_a, span.point_b, span.edge_a, span.part_b, result);
    else
      updateDistance(o1, o2, span.distance, span.point_b, span.point_a, span.part_b, span.edge_a, result);
    return result.min_distance;
  };
  const auto limit = static_cast<double>(result.min_distance);
  const StadiumPair<S> round(o1, tf1, o2, tf2);
  if (round.found == StadiumCase::OutOfSlab) return result.min_distance;
  if (round.found == StadiumCase::Pair && measured(span, round, request, limit)) {
    if (span.distance < 0) requireContactsIfSigned(o1, o2, request);
    return report(round.polygon_first);
  }

  const MixedPair<S> pair = mixedPair("distance", o1, tf1, o2, tf2);
  const std::optional<Shadow> shadow = makeShadow(pair.other, pair.view);
  if (!shadow) return result.min_distance;  // nothing in the polygon's plane to be near to

  const double margin = pair.shape.options().margin;
  const auto within = shadow->distance(pair.polygon(), limit, optionsOf(request, margin));
  if (!within) return result.min_distance;
  tricover::DistanceResult found = *within;
  if (margin > 0 && std::isfinite(found.distance)) moveByMargins(found, margin, 0);
  span = {found.distance, inSpace(found.point_a), inSpace(found.point_b), found.edge_a, shadow->partOf(found.edge_b)};
  if (span.distance == 0) measureOverlap(span, pair, *shadow, request.enable_signed_distance);
  if (span.distance < 0) requireContactsIfSigned(o1, o2, request);
  span.point_a = pair.plane * span.point_a;
  span.point_b = pair.plane * span.point_b;
  return report(pair.polygon_first);
}

template float distanceMixed(const fcl::CollisionGeometry<float>&, const fcl::Transform3<float>&,
                             const fcl::CollisionGeometry<float>&, const fcl::Transform3<float>&,
                             const fcl::DistanceRequest<float>&, fcl::DistanceResult<float>&);
template double distanceMixed(const fcl::CollisionGeometry<double>&, const fcl::Transform3<double>&,
                              const fcl::CollisionGeometry<double>&, const fcl::Transform3<double>&,
                              const fcl::DistanceRequest<double>&, fcl::DistanceResult<double>&);

}  // namespace tricover_fcl
