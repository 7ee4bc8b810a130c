// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "mixed/mixed.h"
#include "mixed/mixed_pair.h"
#include "shadow/stadium.h"
#include "shape/bounds.h"
#include "shape/course.h"
#include "shape/errors.h"
#include "shape/fcl_results.h"
#include "shape/motion_in_plane.h"

namespace tricover_fcl {
namespace {

/// How far the motion takes anything that is within `radius` of `center` before it is put where the motion starts.
double reach(const tricover::Motion& motion, const tricover::Vec2& center, double radius) {
  const double turn = std::abs(motion.angle) + std::abs(motion.angle_2) + std::abs(motion.angle_3);
  const double before =
      (motion.start * center - center).norm() + (motion.start.linear() - Eigen::Matrix2d::Identity()).norm() * radius;
  return before + motion.shift.norm() + motion.shift_2.norm() + motion.shift_3.norm() +
         std::min(turn, 2.0) * ((center - motion.pivot).norm() + radius);
}

/// The course of what lies in the pair's plane, in a box there, by a motion of FCL's; otherwise by its own.
template <typename S>
Course courseOf(const fcl::MotionBase<S>& motion, const MixedPair<S>& pair, const Eigen::AlignedBox2d& around,
                const char* name) {
  const Plane plane = pair.planeOf(pair.view.slab.middle());
  Course course{trajectoryInPlane(motion, plane, name), {}, {}, {}};
  if (course.known) return course;
  const Plane body = Plane(poseAt(motion, S(0)).matrix().template cast<double>().eval()).inverse() * plane;
  return ownCourse(motion, around, plane, body, name);
}

/// How far the course takes anything in the box.
double reach(const Course& course, const Eigen::AlignedBox2d& box) {
  if (!course.known) return course.speed(0);
  double most = 0;
  for (const tricover::Leg& leg : course.known->legs())
    most = std::max(most, reach(leg.motion, box.center(), box.diagonal().norm() / 2));
  return most;
}

void widen(Eigen::AlignedBox2d& box, double by) {
  box.min().array() -= by;
  box.max().array() += by;
}

/// The part of the other geometry in the plane at time 0: a polygon, its pose, and a margin around it.
struct Section {
  tricover::Polygon polygon;
  tricover::Pose pose = tricover::Pose::Identity();
  double margin = 0;

  Eigen::AlignedBox2d box() const {
    Eigen::AlignedBox2d around = boundsOf(polygon, pose);
    widen(around, margin);
    return around;
  }
};

template <typename S>
std::optional<Section> sectionOf(const MixedPair<S>& pair) {
  const Eigen::Vector3d center = pair.view.to_polygon.translation(), axis = pair.view.to_polygon.linear().col(2);
  const double rounding = mappingError(pair.view.to_polygon, 0);
  if (const auto stadium = stadiumOf(pair.other, center, axis, pair.view.slab, rounding, rounding)) {
    if (!stadium->in_slab) return std::nullopt;
    Section section{stadium->segment(), {}, stadium->radius};
    stadium->setPose(section.pose);
    return section;
  }
  const std::optional<Shadow> shadow = makeShadow(pair.other, pair.view);
  if (!shadow) return std::nullopt;
  return Section{shadow->region()};
}

/// The course of what lies at `pose` where the course begins.
Course carried(const Course& course, const tricover::Pose& pose) {
  if (course.known) {
    std::vector<tricover::Leg> legs = course.known->legs();
    for (tricover::Leg& leg : legs) {
      leg.motion.start = leg.motion.start * pose;
      leg.motion.pivot = pose.inverse() * leg.motion.pivot;
    }
    return {tricover::Trajectory(std::move(legs)), {}, {}, {}};
  }
  const auto speed_along = [course, pose](const Eigen::AlignedBox2d& part, const tricover::Vec2& direction,
                                          double time) {
    return course.speed_along(part.transformed(pose), direction, time);
  };
  return {{}, [course, pose](double time) { return course.pose(time) * pose; }, course.speed, speed_along};
}

}  // namespace

template <typename S>
S advanceMixed(const fcl::CollisionGeometry<S>& o1, const fcl::MotionBase<S>& motion1,
               const fcl::CollisionGeometry<S>& o2, const fcl::MotionBase<S>& motion2,
               const fcl::ContinuousCollisionRequest<S>& request, fcl::ContinuousCollisionResult<S>& result) {
  MixedPair<S> pair = mixedPair("conservative advancement", o1, poseAt(motion1, S(0)), o2, poseAt(motion2, S(0)));
  const bool first = pair.polygon_first;
  const fcl::MotionBase<S>& motion_of_other = first ? motion2 : motion1;
  const char* const name_of_other = first ? "motion_b" : "motion_a";
  const Course of_polygon =
      courseOf(first ? motion1 : motion2, pair, pair.view.around, first ? "motion_a" : "motion_b");

  // Both stay in the plane, so the shadow of the start moves with its geometry. It must hold what of an unbounded one
  // the polygon comes to.
  std::optional<Course> of_other;
  const double margin = pair.shape.options().margin;
  const fcl::NODE_TYPE type = pair.other.getNodeType();
  if (type == fcl::GEOM_PLANE || type == fcl::GEOM_HALFSPACE) {
    of_other = courseOf(motion_of_other, pair, pair.view.around, name_of_other);
    if (!of_other->known) {
      refuseQuestion(name_of_other, "what has no end has no bound of its speed, unless one of FCL's motions moves it",
                     "make it an fcl::Box");
    }
    widen(pair.view.around, reach(of_polygon, pair.view.around) + margin);
    widen(pair.view.around, reach(*of_other, pair.view.around));
  }
  std::optional<Section> section = sectionOf(pair);
  if (!of_other) of_other = courseOf(motion_of_other, pair, section ? section->box() : pair.view.around, name_of_other);

  std::optional<double> time;
  if (section && o1.isOccupied() && o2.isOccupied()) {
    tricover::ImpactOptions options;
    options.time_error = static_cast<double>(request.toc_err);
    options.margin = (margin + section->margin) * (1 + (margin > 0 ? 0x1p-52 : 0));
    time = firstContact<S>(pair.polygon(), of_polygon, section->polygon, carried(*of_other, section->pose), options);
  }
  return reportImpact(time, result);
}

template float advanceMixed(const fcl::CollisionGeometry<float>&, const fcl::MotionBase<float>&,
                            const fcl::CollisionGeometry<float>&, const fcl::MotionBase<float>&,
                            const fcl::ContinuousCollisionRequest<float>&, fcl::ContinuousCollisionResult<float>&);
template double advanceMixed(const fcl::CollisionGeometry<double>&, const fcl::MotionBase<double>&,
                             const fcl::CollisionGeometry<double>&, const fcl::MotionBase<double>&,
                             const fcl::ContinuousCollisionRequest<double>&, fcl::ContinuousCollisionResult<double>&);

}  // namespace tricover_fcl
