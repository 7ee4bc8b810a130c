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

#include "numbers/march.h"
#include "numbers/rigidity.h"
#include "shape/errors.h"
#include "shape/motion_in_plane.h"
#include "shape/planar_pose.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/depth.h"
#include "tricover/distance.h"

namespace tricover_fcl {
namespace {

using tricover::Motion;
using tricover::Polygon;
using tricover::Pose;
using tricover::Vec2;
using tricover::detail::march;
using tricover::detail::Reached;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr const char* kSayBound = "make computeMotionBound return a bound of the speed, or ";

/// The pose of a motion that began at `begin`, in `plane`; `body` maps what lies in the plane at time 0 to the frame
/// that moves. Throws std::invalid_argument, naming the motion, if it leaves the plane or isn't finite.
template <typename S>
Pose poseInPlane(const fcl::Transform3<S>& pose, const fcl::Transform3<S>& begin, const Plane& plane, const Plane& body,
                 const char* name) {
  const Plane now = seenFrom(plane, planeOf(pose) * body), first = seenFrom(plane, planeOf(begin) * body);
  const PlanarPose planar = planarPose<double>(now, name);
  const double rise = kTiltTolerance * (now.translation() - first.translation()).head<2>().norm() +
                      8 * static_cast<double>(std::numeric_limits<S>::epsilon()) *
                          (plane.translation().norm() + pose.translation().template cast<double>().norm());
  if (!(std::abs(planar.z) <= rise)) refuseDeparture(name);
  return planar.pose;
}

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

/// A rectangle swept by a ball, as FCL's bounds of motions want it: around what lies in a box in the plane, which
/// `body` maps to the frame that moves.
template <typename S>
fcl::RSS<S> sweptRectangle(const Eigen::AlignedBox2d& part, const Plane& body) {
  Eigen::AlignedBox3d box;
  for (const auto corner : {Eigen::AlignedBox2d::BottomLeft, Eigen::AlignedBox2d::BottomRight,
                            Eigen::AlignedBox2d::TopLeft, Eigen::AlignedBox2d::TopRight}) {
    const Vec2 at = part.corner(corner);
    box.extend(body * Eigen::Vector3d(at.x(), at.y(), 0));
  }
  const Eigen::Vector3d sides = box.sizes() * (1 + 4 * static_cast<double>(std::numeric_limits<S>::epsilon()));
  fcl::RSS<S> rectangle;
  rectangle.axis.setIdentity();
  rectangle.To = Eigen::Vector3d(box.min().x(), box.min().y(), box.center().z()).cast<S>();
  rectangle.l[0] = static_cast<S>(sides.x());
  rectangle.l[1] = static_cast<S>(sides.y());
  rectangle.r = static_cast<S>(sides.z() / 2 + 1e-6 * sides.norm());  // what rounding may have moved
  return rectangle;
}

/// Of the motion's speed along a direction in the plane, since the time that it was integrated to.
template <typename S>
double boundAlong(const fcl::MotionBase<S>& motion, const fcl::RSS<S>& body, const Plane& plane, const Vec2& direction,
                  const char* name) {
  const Eigen::Vector3d in_space = plane.linear() * Eigen::Vector3d(direction.x(), direction.y(), 0);
  const SpeedVisitor<S> visitor(body, in_space.cast<S>(), name);
  const auto bound = static_cast<double>(motion.computeMotionBound(visitor));
  if (!std::isfinite(bound)) {
    refuseQuestion(name, "the bound of the motion " + className(typeid(motion)) + " is not finite",
                   std::string(kSayBound) + kSampleInstead);
  }
  return bound;
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
    largest = std::max(largest, boundAlong(motion, body, plane, Vec2(std::cos(angle), std::sin(angle)), name));
  }
  // Directions are rounded, to floats for float, and poses may stretch what moves.
  return largest / std::cos(M_PI / kDirections) * (1 + 4 * tricover::kRigidTolerance);
}

/// Of a cubic's derivative from `time` to 1: what it is then, measured by `size`, and what its terms may add.
template <class Vector, class Size, class Change>
double rateBound(const Vector& first, const Vector& second, const Vector& third, double time, Size size,
                 Change change) {
  const double rest = 1 - time;
  return size(first + 2 * time * second + 3 * time * time * third) + rest * change(2 * second + 6 * time * third) +
         rest * rest * change(3 * third);
}

double norm(const Vec2& v) { return v.norm(); }
double turnBound(const Motion& motion, double time) {
  const auto size = [](double rate) { return std::abs(rate); };
  return rateBound(motion.angle, motion.angle_2, motion.angle_3, time, size, size);
}

/// Of every point within `radius` of the pivot, from `time` to 1.
double speedOf(const Motion& motion, double radius, double time) {
  const double shift = rateBound(motion.shift, motion.shift_2, motion.shift_3, time, norm, norm);
  return (shift + turnBound(motion, time) * radius) * (1 + 0x1p-40);
}

/// Likewise, of their speed in a direction.
double speedAlong(const Motion& motion, double radius, const Vec2& direction, double time) {
  const auto along = [&](const Vec2& v) { return v.dot(direction); };
  const auto either = [&](const Vec2& v) { return std::abs(v.dot(direction)); };
  const double shift = rateBound(motion.shift, motion.shift_2, motion.shift_3, time, along, either);
  return shift + turnBound(motion, time) * radius + 0x1p-40 * speedOf(motion, radius, time);
}

double radiusAround(const Polygon& polygon, const Vec2& center) {
  double radius = 0;
  for (tricover::EdgeIndex e = 0; e < polygon.edgeCount(); ++e)
    radius = std::max(radius, (polygon.edgeStart(e) - center).norm());
  return radius;
}

/// The functions, whatever the course, for a time in which it is on one leg.
Course asked(const Course& course, const Polygon& polygon, double begin, double end) {
  if (!course.known) return course;
  const Motion motion = course.known->part(begin, end);
  const double radius = (1 + tricover::kRigidTolerance) * radiusAround(polygon, motion.pivot), length = end - begin;
  const auto on_leg = [begin, length](double time) { return std::max((time - begin) / length, 0.0); };
  return {{},
          [motion, on_leg](double time) { return motion.at(on_leg(time)); },
          [=](double time) { return speedOf(motion, radius, on_leg(time)) / length; },
          [=](const Eigen::AlignedBox2d& part, const Vec2& direction, double time) {
            const Vec2 farthest =
                (part.min() - motion.pivot).cwiseAbs().cwiseMax((part.max() - motion.pivot).cwiseAbs());
            const double reach = (1 + tricover::kRigidTolerance) * farthest.norm();
            return speedAlong(motion, reach, direction, on_leg(time)) / length;
          }};
}

/// Vertices that follow each other, and a box around them.
struct VertexRun {
  tricover::Ring vertices;
  Eigen::AlignedBox2d around;
};

std::vector<VertexRun> partsOf(const Polygon& polygon) {
  constexpr tricover::EdgeIndex kMost = 16;
  const tricover::EdgeIndex many = (polygon.edgeCount() + kMost - 1) / kMost;
  std::vector<VertexRun> parts(static_cast<std::size_t>((polygon.edgeCount() + many - 1) / many));
  for (tricover::EdgeIndex e = 0; e < polygon.edgeCount(); ++e) {
    VertexRun& part = parts[static_cast<std::size_t>(e / many)];
    part.vertices.push_back(polygon.edgeStart(e));
    part.around.extend(part.vertices.back());
  }
  return parts;
}

/// A body under way.
template <typename S>
struct Mover {
  const Polygon& polygon;
  const Course& course;
  std::vector<VertexRun> parts = partsOf(polygon);
  double time = 0, speed = 0;
  Pose pose = Pose::Identity();

  void moveTo(double when) {
    time = when;
    pose = course.pose(when);
    speed = course.speed(when);
  }

  /// How far a part has come along a direction, from `origin`, and how fast it may be.
  struct Front {
    double place, speed;
  };
  /// A direction that is rounded, and a pose that stretches what moves, add what they turn or stretch of all of the
  /// speed.
  std::vector<Front> fronts(const Vec2& direction, const Vec2& origin) const {
    const double loose =
        16 * static_cast<double>(std::numeric_limits<S>::epsilon()) + 4 * tricover::detail::defectOf(pose);
    std::vector<Front> fronts;
    for (const VertexRun& part : parts) {
      double place = -kInfinity;
      for (const Vec2& vertex : part.vertices)
        place = std::max(place, direction.dot(pose.linear() * vertex + (pose.translation() - origin)));
      fronts.push_back({place, course.speed_along(part.around, direction, time) + loose * speed});
    }
    return fronts;
  }

  /// In the world, either way; zero for no edge.
  Vec2 normalOf(tricover::EdgeIndex edge) const {
    if (edge < 0) return Vec2::Zero();
    const Vec2 along = pose.linear() * (polygon.edgeEnd(edge) - polygon.edgeStart(edge));
    return Vec2(-along.y(), along.x()).stableNormalized();
  }
};

/// How long a line across `direction` goes on parting what is `beside` and more apart along it (if `beside` is
/// negative, overlaps along it by less, and then by less in all): every part of both has to come to it.
template <typename S>
double partedFor(const Mover<S>& a, const Mover<S>& b, const Vec2& direction, double beside) {
  const Vec2 origin = a.pose.translation();
  const auto of_a = a.fronts(direction, origin), of_b = b.fronts(-direction, origin);
  double least = kInfinity;
  for (const auto& front : of_a) {
    for (const auto& other : of_b) {
      const double gap = -other.place - front.place - beside, speed = front.speed + other.speed;
      if (!(gap > 0)) return 0;
      if (speed > 0) least = std::min(least, gap / speed);
    }
  }
  return least * (1 - 0x1p-50);
}

/// How far points may move before the bodies come as near as the margin or, if it is negative, overlap as deep.
struct Clearance {
  double length;
  Vec2 towards;  ///< from a to b; zero where none is known
  tricover::EdgeIndex edge_a, edge_b;
};

/// Finds it again and again for the same bodies.
class Gauge {
 public:
  Gauge(const Polygon& a, const Polygon& b, double margin)
      : a_(a), b_(b), margin_(margin), has_line_(margin >= 0 || !(a.isComplement() || b.isComplement())) {}

  bool isReached(const Pose& pose_a, const Pose& pose_b) const {
    return tricover::collide(a_, pose_a, b_, pose_b, {margin_});
  }
  /// Less than `least` may be found to be 0.
  Clearance at(const Pose& pose_a, const Pose& pose_b, double least) {
    const auto nearest = tricover::distance(a_, pose_a, b_, pose_b, cache_, {std::max(margin_, 0.0)});
    const bool overlap = margin_ < 0 && nearest.distance == 0;
    const double length = overlap ? allowedDepth(pose_a, pose_b, least) : nearest.distance - std::min(margin_, 0.0);
    if (!has_line_) return {length, Vec2::Zero(), -1, -1};
    if (!overlap)
      return {length, (nearest.point_b - nearest.point_a).stableNormalized(), nearest.edge_a, nearest.edge_b};
    const auto found = tricover::contacts(a_, pose_a, b_, pose_b, {0, 1, tricover::ContactDetail::LocalDepth});
    if (found.empty()) return {length, Vec2::Zero(), -1, -1};
    return {length, found[0].normal, found[0].edge_a, found[0].edge_b};
  }

 private:
  /// By how much the overlap may grow, 0 if that is below `least`. The depth changes by no more than points move.
  double allowedDepth(const Pose& pose_a, const Pose& pose_b, double least) const {
    const double left = -margin_ - tricover::depth(a_, pose_a, b_, pose_b).upper_bound;
    return left > least ? left : 0;
  }

  const Polygon &a_, &b_;
  double margin_;
  bool has_line_;  ///< by which partedFor() proves something: a complement has no front to overlap with by little
  tricover::PairCache cache_;
};

template <typename S>
std::optional<double> advance(const Polygon& polygon_a, const Course& course_a, const Polygon& polygon_b,
                              const Course& course_b, double begin, double end,
                              const tricover::ImpactOptions& options) {
  if (!(std::isfinite(options.time_error) && options.time_error >= 0))
    refuse("time_error", "it must be finite and not negative");
  constexpr double kShort = 1.0 / 64;  // steps below that are worth a look along a direction,
  constexpr int kRest = 15;            // but for so many after one that wasn't
  int resting = 0;
  Mover<S> a{polygon_a, course_a}, b{polygon_b, course_b};
  Gauge gauge(polygon_a, polygon_b, options.margin);
  const double size =
      std::abs(options.margin) + radiusAround(polygon_a, Vec2::Zero()) + radiusAround(polygon_b, Vec2::Zero());
  // A step for each time_error / 16, between 65,536 and a million of them.
  const int most = static_cast<int>(std::ceil(std::clamp(16 / options.time_error, 0x1p16, 0x1p20)));
  const Reached from{static_cast<double>(roundDown<S>(begin)), false}, never{kInfinity, true};
  const auto step = [&](double time) -> std::optional<Reached> {
    a.moveTo(time);
    b.moveTo(time);
    // What the distance is rounded by, and what the motions' poses are, also far from the world's origin.
    const double rounding = 1e-13 * (size + (a.pose.translation() - b.pose.translation()).norm()) +
                            8 * static_cast<double>(std::numeric_limits<S>::epsilon()) *
                                (a.pose.translation().norm() + b.pose.translation().norm());
    const Clearance left = gauge.at(a.pose, b.pose, rounding);
    if (left.length == 0) return std::nullopt;
    double length = (left.length - rounding) / (a.speed + b.speed) * (1 - 0x1p-50);
    if (length < kShort && length < end - time && --resting < 0) {
      const double alone = length;
      for (Vec2 direction : {left.towards, a.normalOf(left.edge_a), b.normalOf(left.edge_b)}) {
        if (direction.dot(left.towards) < 0) direction = -direction;
        if (direction.allFinite() && !direction.isZero(0))
          length = std::max(length, partedFor(a, b, direction, options.margin + rounding));
      }
      resting = length > 2 * alone ? 0 : kRest;
    }
    if (time + length >= end) return never;
    // Motions are asked at times that S has.
    const double next = length > 0 ? static_cast<double>(roundDown<S>(time + length)) : time;
    if (!(next > time)) return std::nullopt;
    const double soon = static_cast<double>(roundDown<S>(std::min(time + options.time_error, end)));
    if (next <= soon && gauge.isReached(course_a.pose(soon), course_b.pose(soon))) return std::nullopt;
    return Reached{next, false};
  };
  // Contact or not, nothing is met before.
  const double time = march(from, most, step).time;
  return time < kInfinity ? std::optional<double>(time) : std::nullopt;
}

}  // namespace

template <typename S>
Course ownCourse(const fcl::MotionBase<S>& motion, const Eigen::AlignedBox2d& box, const Plane& plane,
                 const Plane& body, const char* name) {
  const auto pose = [&motion, begin = poseAt(motion, S(0)), plane, body, name](double time) {
    return poseInPlane(poseAt(motion, static_cast<S>(time)), begin, plane, body, name);
  };
  const auto speed = [&motion, around = sweptRectangle<S>(box, body), plane, name](double time) {
    return speedOf(motion, around, plane, time, name);
  };
  if (speed(0) == 0) return {wholeOf(Motion::still(pose(0))), {}, {}, {}};
  const auto speed_along = [&motion, plane, body, name](const Eigen::AlignedBox2d& part, const Vec2& direction,
                                                        double time) {
    motion.integrate(static_cast<S>(time));
    return boundAlong(motion, sweptRectangle<S>(part, body), plane, direction, name);
  };
  return {{}, pose, speed, speed_along};
}

template <typename S>
std::optional<double> firstContact(const Polygon& a, const Course& course_a, const Polygon& b, const Course& course_b,
                                   const tricover::ImpactOptions& options) {
  for (const Course* course : {&course_a, &course_b})
    if (course->known && course->known->begin() > 1) return std::nullopt;  // never there
  if (course_a.known && course_b.known) {
    const auto impact = tricover::timeOfImpact(a, *course_a.known, b, *course_b.known, options);
    return impact ? std::optional<double>(impact->time) : std::nullopt;
  }
  const auto between = [&](double begin, double end) {
    return advance<S>(a, asked(course_a, a, begin, end), b, asked(course_b, b, begin, end), begin, end, options);
  };
  if (!course_a.known && !course_b.known) return between(0, 1);
  for (const tricover::Leg& leg : (course_a.known ? course_a : course_b).known->legs())
    if (const auto contact = between(leg.begin, leg.end)) return contact;
  return std::nullopt;
}

#define TRICOVER_INSTANTIATE(S)                                                                                \
  template Course ownCourse(const fcl::MotionBase<S>&, const Eigen::AlignedBox2d&, const Plane&, const Plane&, \
                            const char*);                                                                      \
  template std::optional<double> firstContact<S>(const Polygon&, const Course&, const Polygon&, const Course&, \
                                                 const tricover::ImpactOptions&);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
