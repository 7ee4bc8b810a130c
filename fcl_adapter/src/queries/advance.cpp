// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "queries/planar_pair.h"
#include "queries/queries.h"
#include "shape/course.h"
#include "shape/errors.h"
#include "shape/motion_in_plane.h"

namespace tricover_fcl {
namespace {

/// How a region goes on. `end` is FCL's own pose at time 1, of a polygon whose course is known and lasts so long.
struct Mover {
  Course course;
  std::optional<tricover::Pose> end;
};

/// Two regions at time 0, and how they move.
struct MovingPair {
  Mover& of(bool first) { return first ? a : b; }

  PlanarPair regions;
  Mover a, b;
};

/// The course of what lies at `pose` where the course begins.
Course carried(const Course& course, const tricover::Pose& pose) {
  if (course.known) {
    std::vector<tricover::Leg> legs = course.known->legs();
    for (tricover::Leg& leg : legs) leg.motion = startingAt(leg.motion, pose);
    const tricover::Trajectory moved(std::move(legs));
    return {course.known->appears() ? moved.appearing().vanishing() : moved, {}, {}, {}};
  }
  const auto speed_along = [course, pose](const Eigen::AlignedBox2d& part, const tricover::Vec2& direction,
                                          double time) {
    return course.speed_along(part.transformed(pose), direction, time);
  };
  return {{}, [course, pose](double time) { return course.pose(time) * pose; }, course.speed, speed_along};
}

/// Whether the pivot goes straight on at one speed, and nothing turns.
bool onlyShifts(const tricover::Motion& motion) {
  return motion.angle == 0 && motion.angle_2 == 0 && motion.angle_3 == 0 && motion.shift_2.isZero(0) &&
         motion.shift_3.isZero(0);
}

/// Its heights are those of the start: it keeps them.
template <typename S>
Mover movingPolygon(Region& region, const PolygonShape<S>& shape, const fcl::MotionBase<S>& motion, const char* name) {
  const fcl::Transform3<S> begin = poseAt(motion, S(0));
  const Plane plane = planeAt(static_cast<double>(begin.translation().z()));
  const auto in_plane = trajectoryInPlane(motion, plane, name);  // says best what is wrong
  const tricover::Pose start = planarPose(begin, name).pose;
  region.polygon = &shape.polygon();
  region.heights = heightsOf(shape.options(), begin);
  if (!in_plane) {
    const Eigen::AlignedBox2d box = grown(boundsOf(shape.polygon()), std::max(shape.options().margin, 0.0));
    Mover mover{ownCourse(motion, box, plane, Plane::Identity(), name), {}};
    if (mover.course.known) mover.end = mover.course.known->at(1);
    return mover;
  }
  Mover mover{carried({in_plane, {}, {}, {}}, start), {}};
  // FCL's own, rounded in its way; but without a turn its ScrewMotion doesn't end where it should.
  const tricover::Trajectory& known = *mover.course.known;
  if (known.end() == 1)
    mover.end = onlyShifts(known.legs().back().motion) ? known.at(1) : planarPose(poseAt(motion, S(1)), name).pose;
  return mover;
}

/// The course of what lies in the plane, in a box there, by a motion of FCL's; otherwise by its own.
template <typename S>
Course courseOf(const fcl::MotionBase<S>& motion, const Plane& plane, const Eigen::AlignedBox2d& box,
                const char* name) {
  Course course{trajectoryInPlane(motion, plane, name), {}, {}, {}};
  if (course.known) return course;
  const Plane body = planeOf(poseAt(motion, S(0))).inverse() * plane;
  return ownCourse(motion, box, plane, body, name);
}

/// How far the motion takes anything that is within `radius` of `center` before it is put where the motion starts.
double reach(const tricover::Motion& motion, const tricover::Vec2& center, double radius) {
  const double turn = std::abs(motion.angle) + std::abs(motion.angle_2) + std::abs(motion.angle_3);
  const double before =
      (motion.start * center - center).norm() + (motion.start.linear() - Eigen::Matrix2d::Identity()).norm() * radius;
  return before + motion.shift.norm() + motion.shift_2.norm() + motion.shift_3.norm() +
         std::min(turn, 2.0) * ((center - motion.pivot).norm() + radius);
}

/// How far the course takes anything in the box.
double reach(const Course& course, const Eigen::AlignedBox2d& box) {
  if (!course.known) return course.speed(0);
  double most = 0;
  for (const tricover::Leg& leg : course.known->legs())
    most = std::max(most, reach(leg.motion, box.center(), box.diagonal().norm() / 2));
  return most;
}

/// Both stay in the polygon's plane, so the shadow of the start moves with its geometry. It must hold what of an
/// unbounded one the polygon comes to.
template <typename S>
void placeMoving(MovingPair& pair, const MixedGeometries<S>& both, const fcl::MotionBase<S>& of_polygon,
                 const fcl::MotionBase<S>& of_other) {
  requireMixed("conservative advancement", both);
  const bool first = both.polygon_first;
  const char* const other_name = first ? "motion_b" : "motion_a";
  const PolygonShape<S>& shape = both.polygon();
  const Slab slab{shape.options().z_low, shape.options().z_high};
  const Plane plane = planeOf(both.ofPolygon()) * planeAt(slab.middle());
  const Eigen::AlignedBox2d box = boundsOf(shape.polygon());
  Course &course = pair.of(first).course, &other_course = pair.of(!first).course;
  course = courseOf(of_polygon, plane, box, first ? "motion_a" : "motion_b");

  double around = 0;
  const fcl::NODE_TYPE type = both.other().getNodeType();
  const bool is_unbounded = type == fcl::GEOM_PLANE || type == fcl::GEOM_HALFSPACE;
  if (is_unbounded) {
    other_course = courseOf(of_other, plane, box, other_name);
    if (!other_course.known) {
      refuseQuestion(other_name, "what has no end has no bound of its speed, unless one of FCL's motions moves it",
                     "make it an fcl::Box");
    }
    around = reach(course, box);
    around += reach(other_course, grown(box, around + std::abs(shape.options().margin)));
  }
  if (!placeStadium(pair.regions, both, false)) placeShadow(pair.regions, both, false, false, around);
  const bool is_there = pair.regions.apart == 0;
  const Region& other = pair.regions.of(!first);
  if (!is_unbounded) other_course = courseOf(of_other, plane, is_there ? boxOf(other) : box, other_name);
  if (is_there) other_course = carried(other_course, other.pose);
}

}  // namespace

template <typename S>
S advanceGeometries(const fcl::CollisionGeometry<S>& o1, const fcl::MotionBase<S>& motion1,
                    const fcl::CollisionGeometry<S>& o2, const fcl::MotionBase<S>& motion2,
                    const fcl::ContinuousCollisionRequest<S>& request, fcl::ContinuousCollisionResult<S>& result) {
  const bool first = isPolygon(o1), second = isPolygon(o2);
  if (!first && !second) {
    warnAsFcl("collision", o1, o2);
    return -1;
  }
  MovingPair pair;
  PlanarPair& regions = pair.regions;
  if (first && second) {
    const auto &shape_a = static_cast<const PolygonShape<S>&>(o1), &shape_b = static_cast<const PolygonShape<S>&>(o2);
    pair.a = movingPolygon(regions.a, shape_a, motion1, "motion_a");
    pair.b = movingPolygon(regions.b, shape_b, motion2, "motion_b");
    regions.margin = shape_a.options().margin + shape_b.options().margin;
    regions.apart = gap(regions.a.heights, regions.b.heights);
  } else {
    const fcl::Transform3<S> begin1 = poseAt(motion1, S(0)), begin2 = poseAt(motion2, S(0));
    placeMoving(pair, MixedGeometries<S>{o1, begin1, o2, begin2}, first ? motion1 : motion2, first ? motion2 : motion1);
  }

  std::optional<double> time;
  if (o1.isOccupied() && o2.isOccupied() && regions.apart == 0) {
    const tricover::Polygon &a = *regions.a.polygon, &b = *regions.b.polygon;
    tricover::ImpactOptions options;
    options.time_error = static_cast<double>(request.toc_err);
    options.margin = regions.margin;
    time = firstContact<S>(a, pair.a.course, b, pair.b.course, options);
    if (!time && pair.a.end && pair.b.end && tricover::collide(a, *pair.a.end, b, *pair.b.end, {options.margin}))
      time = 1;
  }
  result.is_collide = time.has_value();
  result.time_of_contact = roundDown<S>(time.value_or(1));
  return result.time_of_contact;
}

template <typename S>
S advanceWithPoses(const fcl::CollisionGeometry<S>& o1, const fcl::MotionBase<S>& motion1,
                   const fcl::CollisionGeometry<S>& o2, const fcl::MotionBase<S>& motion2,
                   const fcl::ContinuousCollisionRequest<S>& request, fcl::ContinuousCollisionResult<S>& result) {
  const S time = advanceGeometries(o1, motion1, o2, motion2, request, result);
  if (result.is_collide) {
    result.contact_tf1 = poseAt(motion1, time);
    result.contact_tf2 = poseAt(motion2, time);
  }
  return time;
}

#define TRICOVER_INSTANTIATE(S)                                                                                \
  template S advanceGeometries(const fcl::CollisionGeometry<S>&, const fcl::MotionBase<S>&,                    \
                               const fcl::CollisionGeometry<S>&, const fcl::MotionBase<S>&,                    \
                               const fcl::ContinuousCollisionRequest<S>&, fcl::ContinuousCollisionResult<S>&); \
  template S advanceWithPoses(const fcl::CollisionGeometry<S>&, const fcl::MotionBase<S>&,                     \
                              const fcl::CollisionGeometry<S>&, const fcl::MotionBase<S>&,                     \
                              const fcl::ContinuousCollisionRequest<S>&, fcl::ContinuousCollisionResult<S>&);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
