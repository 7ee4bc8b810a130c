// SPDX-License-Identifier: BSD-3-Clause
#include <optional>
#include <utility>
#include <vector>

#include "polygons/polygons.h"
#include "shape/course.h"
#include "shape/fcl_results.h"
#include "shape/heights.h"
#include "shape/motion_in_plane.h"
#include "shape/planar_pose.h"
#include "tricover/collide.h"

namespace tricover_fcl {
namespace {

/// Its heights are those of `start`: it keeps them.
struct MovingPolygon {
  Heights heights(const PolygonOptions& shape) const { return heightsOf(shape, start.z, start.upside_down); }

  PlanarPose start;
  Course course;
  tricover::Pose end;  ///< of a course that is known
};

/// Whether the pivot goes straight on at one speed, and nothing turns.
bool onlyShifts(const tricover::Motion& motion) {
  return motion.angle == 0 && motion.angle_2 == 0 && motion.angle_3 == 0 && motion.shift_2.isZero(0) &&
         motion.shift_3.isZero(0);
}

template <typename S>
MovingPolygon movingPolygon(const PolygonShape<S>& shape, const fcl::MotionBase<S>& motion, const char* name) {
  const fcl::Transform3<S> begin = poseAt(motion, S(0));
  const Plane plane = planeAt(static_cast<double>(begin.translation().z()));
  const auto in_plane = trajectoryInPlane(motion, plane, name);  // says best what is wrong
  MovingPolygon moving{planarPose(begin, name), {in_plane, {}, {}, {}}, {}};
  if (!moving.course.known) {
    const auto corner = [](const fcl::Vector3<S>& at) {
      return tricover::Vec2(at.template head<2>().template cast<double>());
    };
    const Eigen::AlignedBox2d box(corner(shape.aabb_local.min_), corner(shape.aabb_local.max_));
    moving.course = ownCourse(motion, box, plane, Plane::Identity(), name);
    if (moving.course.known) moving.end = moving.course.known->at(1);
    return moving;
  }
  std::vector<tricover::Leg> legs = in_plane->legs();
  for (tricover::Leg& leg : legs) leg.motion = startingAt(leg.motion, moving.start.pose);
  const tricover::Trajectory& known = moving.course.known.emplace(std::move(legs));
  // FCL's own, rounded in its way; but without a turn its ScrewMotion doesn't end where it should.
  moving.end = onlyShifts(known.legs().back().motion) ? known.at(1) : planarPose(poseAt(motion, S(1)), name).pose;
  return moving;
}

}  // namespace

template <typename S>
S advancePolygons(const fcl::CollisionGeometry<S>& o1, const fcl::MotionBase<S>& motion1,
                  const fcl::CollisionGeometry<S>& o2, const fcl::MotionBase<S>& motion2,
                  const fcl::ContinuousCollisionRequest<S>& request, fcl::ContinuousCollisionResult<S>& result) {
  const auto& shape_a = static_cast<const PolygonShape<S>&>(o1);
  const auto& shape_b = static_cast<const PolygonShape<S>&>(o2);
  const MovingPolygon a = movingPolygon(shape_a, motion1, "motion_a"), b = movingPolygon(shape_b, motion2, "motion_b");

  std::optional<double> time;
  if (o1.isOccupied() && o2.isOccupied() && share(a.heights(shape_a.options()), b.heights(shape_b.options()))) {
    tricover::ImpactOptions options;
    options.time_error = static_cast<double>(request.toc_err);
    options.margin = shape_a.options().margin + shape_b.options().margin;
    time = firstContact<S>(shape_a.polygon(), a.course, shape_b.polygon(), b.course, options);
    if (!time && a.course.known && b.course.known &&
        tricover::collide(shape_a.polygon(), a.end, shape_b.polygon(), b.end, {options.margin}))
      time = 1;
  }
  return reportImpact(time, result);
}

#define TRICOVER_INSTANTIATE(S)                                                           \
  template S advancePolygons(const fcl::CollisionGeometry<S>&, const fcl::MotionBase<S>&, \
                             const fcl::CollisionGeometry<S>&, const fcl::MotionBase<S>&, \
                             const fcl::ContinuousCollisionRequest<S>&, fcl::ContinuousCollisionResult<S>&);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
