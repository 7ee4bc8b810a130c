// SPDX-License-Identifier: BSD-3-Clause
#include "mixed/distance_mixed.h"

#include <algorithm>
#include <limits>

#include "mixed/mixed_pair.h"
#include "shape/fcl_results.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"

namespace tricover_fcl {
namespace {

/// In the polygon's frame, `a` on the polygon.
struct Span {
  double distance;
  Eigen::Vector3d point_a, point_b;
  std::ptrdiff_t edge_a, part_b;
};

Eigen::Vector3d inSpace(const tricover::Vec2& p) { return {p.x(), p.y(), 0}; }

/// What is told of two that meet. What isn't deeper than the outline errs is a touch, but for surfaces if depths don't
/// matter: FCL asks collide about a negative distance, and insists on a depth that is a normal number.
template <typename S>
void measureOverlap(Span& span, const MixedPair<S>& pair, const Shadow& shadow, bool is_signed) {
  using tricover::Pose;
  const double touch = std::max(shadow.outlineError(), static_cast<double>(std::numeric_limits<S>::min()));
  if (const auto& lift = shadow.lift()) {
    if (!(lift->depth > touch)) return;
    span.distance = is_signed ? -lift->depth : -1;
    span.point_a = inSpace(pair.polygon().origin());
    span.point_b = span.point_a - lift->depth * lift->normal;
  } else if (is_signed) {
    const auto whole = shadow.penetration(pair.polygon());
    if (!whole || !(whole->depth > touch)) return;
    span = {-whole->depth, inSpace(whole->point_a), inSpace(whole->point_b), whole->edge_a,
            shadow.partOf(whole->edge_b)};
  } else {
    const auto overlaps = [&](const tricover::Polygon& region) {
      const auto deepest = tricover::contacts(pair.polygon(), Pose::Identity(), region, Pose::Identity(), 1);
      return !deepest.empty() && deepest.front().depth > touch;
    };
    if (shadow.isSurface() || overlaps(shadow.core()) || overlaps(shadow.outlineIn(pair.polygon()))) span.distance = -1;
  }
}

}  // namespace

template <typename S>
S distanceMixed(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1, const fcl::CollisionGeometry<S>& o2,
                const fcl::Transform3<S>& tf2, const fcl::DistanceRequest<S>& request, fcl::DistanceResult<S>& result) {
  if (request.isSatisfied(result)) return result.min_distance;
  const MixedPair<S> pair = mixedPair("distance", o1, tf1, o2, tf2);
  const std::optional<Shadow> shadow = makeShadow(pair.other, pair.view);
  if (!shadow) return result.min_distance;  // nothing in the polygon's plane to be near to

  tricover::DistanceOptions options;
  options.relative_error = static_cast<double>(request.rel_err);
  options.absolute_error = static_cast<double>(request.abs_err);
  options.limit = static_cast<double>(result.min_distance);
  const tricover::DistanceResult found = shadow->distance(pair.polygon(), options);
  Span span{found.distance, inSpace(found.point_a), inSpace(found.point_b), found.edge_a, shadow->partOf(found.edge_b)};
  if (span.distance == 0) measureOverlap(span, pair, *shadow, request.enable_signed_distance);
  if (span.distance < 0) requireContactsIfSigned(o1, o2, request);

  const Eigen::Vector3d at_a = pair.plane * span.point_a, at_b = pair.plane * span.point_b;
  if (pair.polygon_first)
    updateDistance(o1, o2, span.distance, at_a, at_b, span.edge_a, span.part_b, result);
  else
    updateDistance(o1, o2, span.distance, at_b, at_a, span.part_b, span.edge_a, result);
  return result.min_distance;
}

template float distanceMixed(const fcl::CollisionGeometry<float>&, const fcl::Transform3<float>&,
                             const fcl::CollisionGeometry<float>&, const fcl::Transform3<float>&,
                             const fcl::DistanceRequest<float>&, fcl::DistanceResult<float>&);
template double distanceMixed(const fcl::CollisionGeometry<double>&, const fcl::Transform3<double>&,
                              const fcl::CollisionGeometry<double>&, const fcl::Transform3<double>&,
                              const fcl::DistanceRequest<double>&, fcl::DistanceResult<double>&);

}  // namespace tricover_fcl
