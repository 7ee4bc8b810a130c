// SPDX-License-Identifier: BSD-3-Clause
#include "shape/course.h"

#include <fcl/math/motion/interp_motion.h>
#include <fcl/math/motion/screw_motion.h>
#include <fcl/math/motion/spline_motion.h>
#include <fcl/math/motion/tbv_motion_bound_visitor.h>
#include <fcl/math/motion/translation_motion.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <typeinfo>

#include "shape/errors.h"
#include "shape/motion_in_plane.h"
#include "tricover/collide.h"
#include "tricover/distance.h"

namespace tricover_fcl {
namespace {

using tricover::Motion;
using tricover::Polygon;
using tricover::Pose;
using tricover::Vec2;

constexpr const char* kSayBound = "make computeMotionBound return a bound of the speed, or ";

/// FCL's own visitor, but for one question: of a motion that isn't FCL's it knows nothing, and says 0.
template <typename S>
class SpeedVisitor final : public fcl::TBVMotionBoundVisitor<fcl::RSS<S>> {
 public:
  SpeedVisitor(const fcl::RSS<S>& body, const fcl::Vector3<S>& direction, const char* name)
      : fcl::TBVMotionBoundVisitor<fcl::RSS<S>>(body, direction), name_(name) {}

  using fcl::TBVMotionBoundVisitor<fcl::RSS<S>>::visit;
  S visit(const fcl::MotionBase<S>& motion) const override {
    refuseQuestion(name_, "FCL's visitor knows no bound of the motion " + className(typeid(motion)),
                   std::string(kSayBound) + kSampleInstead);
  }

 private:
  const char* name_;
};

/// A rectangle swept by a ball, as FCL's bounds of motions want it.
template <typename S>
fcl::RSS<S> sweptRectangle(const Eigen::AlignedBox3d& box) {
  const Eigen::Vector3d sides = box.sizes() * (1 + 4 * static_cast<double>(std::numeric_limits<S>::epsilon()));
  fcl::RSS<S> body;
  body.axis.setIdentity();
  body.To = Eigen::Vector3d(box.min().x(), box.min().y(), box.center().z()).cast<S>();
  body.l[0] = static_cast<S>(sides.x());
  body.l[1] = static_cast<S>(sides.y());
  body.r = static_cast<S>(sides.z() / 2 + 1e-6 * sides.norm());  // what rounding may have moved
  return body;
}

/// Bounds v . n are asked for in directions all around. What they leave of the plane for v is a polygon around the
/// circle of the largest of them, which reaches 1 / cos(pi / k) as far.
template <typename S>
double speedOf(const fcl::MotionBase<S>& motion, const fcl::RSS<S>& body, const Plane& plane, double time,
               const char* name) {
  constexpr int kDirections = 16;
  motion.integrate(static_cast<S>(time));
  double largest = 0;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2 * M_PI * i / kDirections;
    const Eigen::Vector3d direction = plane.linear() * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
    const SpeedVisitor<S> visitor(body, direction.cast<S>(), name);
    const auto bound = static_cast<double>(motion.computeMotionBound(visitor));
    if (!std::isfinite(bound)) {
      refuseQuestion(name, "the bound of the motion " + className(typeid(motion)) + " is not finite",
                     std::string(kSayBound) + kSampleInstead);
    }
    largest = std::max(largest, bound);
  }
  // Directions are rounded, to floats for float, and poses may stretch what moves.
  return largest / std::cos(M_PI / kDirections) * (1 + 4 * tricover::kRigidTolerance);
}

/// Of every point within `radius` of the pivot, from `time` to 1: what the velocities are then, and what their terms
/// may add.
double speedOf(const Motion& motion, double radius, double time) {
  const double rest = 1 - time;
  const auto bound = [&](const auto& size, const auto& first, const auto& second, const auto& third) {
    return size(first + 2 * time * second + 3 * time * time * third) + rest * size(2 * second + 6 * time * third) +
           rest * rest * size(3 * third);
  };
  const double shift = bound([](const Vec2& v) { return v.norm(); }, motion.shift, motion.shift_2, motion.shift_3);
  const double turn = bound([](double rate) { return std::abs(rate); }, motion.angle, motion.angle_2, motion.angle_3);
  return (shift + turn * radius) * (1 + 0x1p-40);
}

double radiusAround(const Polygon& polygon, const Vec2& center) {
  double radius = 0;
  for (tricover::EdgeIndex e = 0; e < polygon.edgeCount(); ++e)
    radius = std::max(radius, (polygon.edgeStart(e) - center).norm());
  return radius;
}

/// The functions, whatever the course.
Course asked(const Course& course, const Polygon& polygon) {
  if (!course.known) return course;
  const Motion& motion = *course.known;
  const double radius = (1 + tricover::kRigidTolerance) * radiusAround(polygon, motion.pivot);
  return {{},
          [motion](double time) { return motion.at(time); },
          [motion, radius](double time) { return speedOf(motion, radius, time); }};
}

template <typename S>
std::optional<CourseContact> advance(const Polygon& a, const Course& course_a, const Polygon& b, const Course& course_b,
                                     const tricover::ImpactOptions& options) {
  if (!(std::isfinite(options.time_error) && options.time_error >= 0))
    refuse("time_error", "it must be finite and not negative");
  const auto collide = [&](double time) {
    tricover::CollideOptions within;
    within.margin = options.margin;
    return tricover::collide(a, course_a.pose(time), b, course_b.pose(time), within);
  };
  const double size = options.margin + radiusAround(a, Vec2::Zero()) + radiusAround(b, Vec2::Zero());
  tricover::PairCache facts;
  tricover::DistanceOptions beyond;
  beyond.margin = options.margin;
  for (double time = 0;;) {
    const Pose pose_a = course_a.pose(time), pose_b = course_b.pose(time);
    const tricover::DistanceResult nearest = tricover::distance(a, pose_a, b, pose_b, facts, beyond);
    const CourseContact contact{time, nearest.edge_b};
    const double apart = nearest.distance;
    if (apart == 0) return contact;
    // What the distance is rounded by, and what the motions' poses are, also far from the world's origin.
    const double rounding = 1e-13 * (size + (pose_a.translation() - pose_b.translation()).norm()) +
                            8 * static_cast<double>(std::numeric_limits<S>::epsilon()) *
                                (pose_a.translation().norm() + pose_b.translation().norm());
    const double speed = course_a.speed(time) + course_b.speed(time);
    const double free_until = time + (apart - rounding) / speed * (1 - 0x1p-50);
    if (free_until >= 1) return std::nullopt;
    // Motions are asked at times that S has.
    const double next = free_until > time ? static_cast<double>(roundDown<S>(free_until)) : time;
    if (!(next > time)) return contact;
    const double soon = static_cast<double>(roundDown<S>(std::min(time + options.time_error, 1.0)));
    if (next <= soon && collide(soon)) return contact;
    time = next;
  }
}

}  // namespace

template <typename S>
Course ownCourse(const fcl::MotionBase<S>& motion, const Eigen::AlignedBox3d& box, const Plane& plane,
                 const Plane& body, const char* name) {
  const auto pose = [&motion, begin = poseAt(motion, S(0)), plane, body, name](double time) {
    return poseInPlane(poseAt(motion, static_cast<S>(time)), begin, plane, body, name);
  };
  const auto speed = [&motion, around = sweptRectangle<S>(box), plane, name](double time) {
    return speedOf(motion, around, plane, time, name);
  };
  if (speed(0) == 0) return {Motion::still(pose(0)), {}, {}};
  return {{}, pose, speed};
}

template <typename S>
std::optional<CourseContact> firstContact(const Polygon& a, const Course& course_a, const Polygon& b,
                                          const Course& course_b, const tricover::ImpactOptions& options) {
  if (!course_a.known || !course_b.known) return advance<S>(a, asked(course_a, a), b, asked(course_b, b), options);
  if (const auto impact = tricover::timeOfImpact(a, *course_a.known, b, *course_b.known, options))
    return CourseContact{impact->time, impact->edge_b};
  return std::nullopt;
}

#define TRICOVER_INSTANTIATE(S)                                                                                       \
  template Course ownCourse(const fcl::MotionBase<S>&, const Eigen::AlignedBox3d&, const Plane&, const Plane&,        \
                            const char*);                                                                             \
  template std::optional<CourseContact> firstContact<S>(const Polygon&, const Course&, const Polygon&, const Course&, \
                                                        const tricover::ImpactOptions&);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
