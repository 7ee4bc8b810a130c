// SPDX-License-Identifier: BSD-3-Clause
#include "advance_polygons.h"

#include <cmath>
#include <optional>

#include "heights.h"
#include "planar_motion.h"
#include "tricover/collide.h"
#include "tricover/time_of_impact.h"
#include "unsupported.h"

namespace tricover_fcl {
namespace {

/// Not above `time`.
template <typename S>
S roundDown(double time) {
  const S rounded = static_cast<S>(time);
  return static_cast<double>(rounded) <= time ? rounded : std::nextafter(rounded, S(0));
}

}  // namespace

template <typename S>
S advancePolygons(const fcl::CollisionGeometry<S>& o1, const fcl::MotionBase<S>& motion1,
                  const fcl::CollisionGeometry<S>& o2, const fcl::MotionBase<S>& motion2,
                  const fcl::ContinuousCollisionRequest<S>& request, fcl::ContinuousCollisionResult<S>& result) {
  const auto& shape_a = static_cast<const PolygonShape<S>&>(o1);
  const auto& shape_b = static_cast<const PolygonShape<S>&>(o2);
  if (shape_a.options().margin > 0 || shape_b.options().margin > 0) {
    throwUnsupported("conservative advancement, with a margin,", o1, o2);
  }
  const tricover::Polygon &a = shape_a.polygon(), &b = shape_b.polygon();
  const PlanarMotion along_a = planarMotion(motion1, "motion_a"), along_b = planarMotion(motion2, "motion_b");

  std::optional<double> time;
  if (o1.isOccupied() && o2.isOccupied() &&
      share(heightsOf(shape_a.options(), along_a.start), heightsOf(shape_b.options(), along_b.start))) {
    tricover::ImpactOptions options;
    options.time_error = static_cast<double>(request.toc_err);
    if (const auto impact = tricover::timeOfImpact(a, along_a.motion, b, along_b.motion, options)) {
      time = impact->time;
    } else if (tricover::collide(a, along_a.end.pose, b, along_b.end.pose)) {
      time = 1;  // the motions end there but for rounding
    }
  }
  result.is_collide = time.has_value();
  result.time_of_contact = roundDown<S>(time.value_or(1));
  return result.time_of_contact;
}

#define TRICOVER_INSTANTIATE(S)                                                           \
  template S advancePolygons(const fcl::CollisionGeometry<S>&, const fcl::MotionBase<S>&, \
                             const fcl::CollisionGeometry<S>&, const fcl::MotionBase<S>&, \
                             const fcl::ContinuousCollisionRequest<S>&, fcl::ContinuousCollisionResult<S>&);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
