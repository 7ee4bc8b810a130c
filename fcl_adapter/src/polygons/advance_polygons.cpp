// SPDX-License-Identifier: BSD-3-Clause
#include "polygons/advance_polygons.h"

#include <fcl/math/motion/spline_motion.h>

#include <cmath>
#include <optional>
#include <typeinfo>

#include "shape/heights.h"
#include "shape/motion_in_plane.h"
#include "tricover/collide.h"
#include "tricover/time_of_impact.h"

namespace tricover_fcl {
namespace {

/// Not above `time`.
template <typename S>
S roundDown(double time) {
  const S rounded = static_cast<S>(time);
  return static_cast<double>(rounded) <= time ? rounded : std::nextafter(rounded, S(0));
}

/// Its heights are those of `start`: it keeps them.
struct MovingPolygon {
  PlanarPose start;
  tricover::Motion motion;
  tricover::Pose end;
};

template <typename S>
MovingPolygon movingPolygon(const fcl::MotionBase<S>& motion, const char* name) {
  const fcl::Transform3<S> begin = poseAt(motion, S(0));
  const tricover::Motion in_plane = motionInPlane(motion, planeAt(static_cast<double>(begin.translation().z())), name);
  MovingPolygon moving{planarPose(begin, name), in_plane, {}};
  const tricover::Pose& start = moving.motion.start = moving.start.pose;
  moving.motion.pivot = start.linear().inverse() * (in_plane.pivot - start.translation());
  // FCL's own, rounded in its way; but without a turn its ScrewMotion doesn't end where it should.
  const bool ends_right = in_plane.angle != 0 || typeid(motion) == typeid(fcl::SplineMotion<S>);
  moving.end = ends_right ? planarPose(poseAt(motion, S(1)), name).pose : moving.motion.at(1);
  return moving;
}

}  // namespace

template <typename S>
S advancePolygons(const fcl::CollisionGeometry<S>& o1, const fcl::MotionBase<S>& motion1,
                  const fcl::CollisionGeometry<S>& o2, const fcl::MotionBase<S>& motion2,
                  const fcl::ContinuousCollisionRequest<S>& request, fcl::ContinuousCollisionResult<S>& result) {
  const auto& shape_a = static_cast<const PolygonShape<S>&>(o1);
  const auto& shape_b = static_cast<const PolygonShape<S>&>(o2);
  const MovingPolygon a = movingPolygon(motion1, "motion_a"), b = movingPolygon(motion2, "motion_b");

  std::optional<double> time;
  if (o1.isOccupied() && o2.isOccupied() &&
      share(heightsOf(shape_a.options(), a.start), heightsOf(shape_b.options(), b.start))) {
    tricover::ImpactOptions options;
    options.time_error = static_cast<double>(request.toc_err);
    options.margin = shape_a.options().margin + shape_b.options().margin;
    if (const auto impact = tricover::timeOfImpact(shape_a.polygon(), a.motion, shape_b.polygon(), b.motion, options)) {
      time = impact->time;
    } else if (tricover::collide(shape_a.polygon(), a.end, shape_b.polygon(), b.end, {options.margin})) {
      time = 1;
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
