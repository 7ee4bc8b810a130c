// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/math/motion/motion_base.h>

#include <Eigen/Geometry>
#include <functional>
#include <optional>

#include "shape/plane.h"
#include "tricover/polygon.h"
#include "tricover/time_of_impact.h"
#include "tricover/trajectory.h"

namespace tricover_fcl {

/// How a body moves in the plane.
struct Course {
  /// All of it, from time 0 to 1, where that is known: the body is absent before it begins and after it ends. Otherwise
  /// the functions are there, which ask the motion.
  std::optional<tricover::Trajectory> known;
  std::function<tricover::Pose(double time)> pose;
  std::function<double(double time)> speed;  ///< bounds that of every point of the body from `time` to 1
  /// Bounds the speed in a direction of the plane, from `time` to 1, of what of the body is in the box, where it is at
  /// time 0; below 0 where all of it comes the other way.
  std::function<double(const Eigen::AlignedBox2d& part, const tricover::Vec2& direction, double time)> speed_along;
};

/// The course of a motion whose class FCL doesn't have, by the poses it gives and by its computeMotionBound. It is
/// known, at rest, where the bound at time 0 is 0. `box` holds the body in the plane at time 0; `plane` and `body` are
/// those of poseInPlane(), which says what the functions throw. So does a bound that is no number: std::logic_error,
/// naming the motion.
template <typename S>
Course ownCourse(const fcl::MotionBase<S>& motion, const Eigen::AlignedBox2d& box, const Plane& plane,
                 const Plane& body, const char* name);

/// The time of the first contact, as tricover::timeOfImpact means it, by that function where both courses are known,
/// otherwise by conservative advancement: while the two are d apart and neither point is faster than v against the
/// other, there is no contact within d / v; nor while an edge's line, or the nearest points', separates them, which
/// each part of both comes to by its own speed along the normal. Where a negative margin allows an overlap, what its
/// depth leaves of that takes the place of the distance. (Poses are taken to stay as rigid as they are.) Coming
/// within 1e-13 of size and distance, and 1e-15 of the distance from the world's origin (for float: 1e-6), is taken for
/// contact.
///
/// Steps go on until they reach a contact or the end, or for 16 / time_error of them (but 65,536 at least and a million
/// at most). After so many, the time that they have reached is returned: a proven lower bound of the first contact's,
/// of which it isn't known whether there is any. Beside a wall at a distance d, a motion that bounds its speed in no
/// direction better than in another takes of the order of 1 / d steps, because it may swerve between any two times.
template <typename S>
std::optional<double> firstContact(const tricover::Polygon& a, const Course& course_a, const tricover::Polygon& b,
                                   const Course& course_b, const tricover::ImpactOptions& options);

}  // namespace tricover_fcl
