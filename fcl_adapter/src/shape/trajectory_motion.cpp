// SPDX-License-Identifier: BSD-3-Clause
#include "tricover_fcl/trajectory_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <typeinfo>

#include "shape/errors.h"
#include "shape/motion_in_plane.h"
#include "shape/planar_pose.h"

namespace tricover_fcl {
namespace {

using tricover::Leg;
using tricover::Trajectory;

/// What of it is from `begin` to `end`, which are its times 0 and 1. Without the rests before and after it if its body
/// is absent then; a body that is never there until time 1 gets a leg after that.
Trajectory fromZeroToOne(const Trajectory& trajectory, double begin, double end) {
  const double length = end - begin;
  if (!(length > 0 && std::isfinite(length))) refuse("end", "it must be after begin, both finite");
  const double until = trajectory.vanishes() ? std::min(end, trajectory.end()) : end;
  double from = trajectory.appears() ? std::max(begin, trajectory.begin()) : begin;
  std::vector<double> times = {until, trajectory.begin()};
  for (const Leg& leg : trajectory.legs()) times.push_back(leg.end);
  std::sort(times.begin(), times.end());
  std::vector<Leg> legs;
  double begins = (from - begin) / length;
  for (const double time : times) {
    if (time <= from || time > until) continue;
    const double ends = time == end ? 1 : (time - begin) / length;
    if (ends > begins) legs.push_back({begins, ends, trajectory.part(from, time)});  // or for FCL it takes no time
    from = time, begins = ends;
  }
  if (legs.empty()) legs.push_back({2, 3, tricover::Motion::still(trajectory.at(begin))});
  return Trajectory(std::move(legs));
}

template <typename S>
Trajectory trajectoryOf(const std::vector<TimedMotion<S>>& timed, double& z) {
  std::vector<Leg> legs;
  bool upside_down = false;
  for (std::size_t i = 0; i < timed.size(); ++i) {
    const std::string name = "legs[" + std::to_string(i) + "].motion";
    if (!timed[i].motion) refuse(name, "there is none");
    const fcl::MotionBase<S>& motion = *timed[i].motion;
    const fcl::Transform3<S> begin = poseAt(motion, S(0));
    const PlanarPose start = planarPose(begin, name.c_str());
    if (i == 0) z = start.z, upside_down = start.upside_down;
    const double rounding = 64 * static_cast<double>(std::numeric_limits<S>::epsilon()) *
                            begin.translation().template cast<double>().norm();
    if (!(std::abs(start.z - z) <= rounding) || start.upside_down != upside_down)
      refuse(name, "it is at another height, or the other way up, than the first");
    const std::optional<tricover::Motion> in_plane = motionInPlane(motion, planeAt(z), name.c_str());
    if (!in_plane)
      refuse(name, className(typeid(motion)) + " is none of FCL's motions, or is a trajectory already",
             "make a tricover::Trajectory");
    legs.push_back({timed[i].begin, timed[i].end, startingAt(*in_plane, start.pose)});
  }
  return Trajectory(std::move(legs));
}

Trajectory shown(const Trajectory& trajectory, bool appears, bool vanishes) {
  const Trajectory from_begin = appears ? trajectory.appearing() : trajectory;
  return vanishes ? from_begin.vanishing() : from_begin;
}

[[noreturn]] void refuseOwnPairs() {
  refuseQuestion("motion", "FCL's conservative advancement and its boxes of motions know no TrajectoryMotion",
                 "use fcl::continuousCollide with CCDC_NAIVE, which asks collide at several times");
}

}  // namespace

template <typename S>
void requireSampled(const fcl::MotionBase<S>& motion, const fcl::ContinuousCollisionRequest<S>& request) {
  if (typeid(motion) != typeid(TrajectoryMotion<S>)) return;
  if (request.ccd_solver_type != fcl::CCDC_NAIVE) refuseOwnPairs();
  const Trajectory& known = static_cast<const TrajectoryMotion<S>&>(motion).trajectory();
  if (known.begin() > 0 || known.end() < 1)
    refuseQuestion("motion", "its body is absent for a part of the time, and FCL would let it rest then",
                   "make one of the two geometries a PolygonShape");
}

template <typename S>
TrajectoryMotion<S>::TrajectoryMotion(const Trajectory& trajectory, double begin, double end, double z)
    : begin_(begin), length_(end - begin), z_(z), trajectory_(fromZeroToOne(trajectory, begin, end)) {
  if (!std::isfinite(z)) refuse("z", "it is not finite");
}

template <typename S>
TrajectoryMotion<S>::TrajectoryMotion(const std::vector<TimedMotion<S>>& legs, double begin, double end, bool appears,
                                      bool vanishes)
    : begin_(begin),
      length_(end - begin),
      z_(0),
      trajectory_(fromZeroToOne(shown(trajectoryOf(legs, z_), appears, vanishes), begin, end)) {}

template <typename S>
bool TrajectoryMotion<S>::integrate(S time) const {
  time_ = time;
  return true;
}

template <typename S>
void TrajectoryMotion<S>::getCurrentTransform(fcl::Transform3<S>& pose) const {
  const tricover::Pose planar = trajectory_.at(static_cast<double>(time_));
  pose.setIdentity();
  pose.linear().template topLeftCorner<2, 2>() = planar.linear().cast<S>();
  // A mirror image in the plane is what is seen of a body upside down.
  if (planar.linear().determinant() < 0) pose.linear()(2, 2) = -1;
  pose.translation() << static_cast<S>(planar.translation().x()), static_cast<S>(planar.translation().y()),
      static_cast<S>(z_);
}

template <typename S>
S TrajectoryMotion<S>::computeMotionBound(const fcl::BVMotionBoundVisitor<S>&) const {
  refuseOwnPairs();
}
template <typename S>
S TrajectoryMotion<S>::computeMotionBound(const fcl::TriangleMotionBoundVisitor<S>&) const {
  refuseOwnPairs();
}
template <typename S>
void TrajectoryMotion<S>::getTaylorModel(fcl::TMatrix3<S>&, fcl::TVector3<S>&) const {
  refuseOwnPairs();
}

template class TrajectoryMotion<float>;
template class TrajectoryMotion<double>;
template void requireSampled(const fcl::MotionBase<float>&, const fcl::ContinuousCollisionRequest<float>&);
template void requireSampled(const fcl::MotionBase<double>&, const fcl::ContinuousCollisionRequest<double>&);

}  // namespace tricover_fcl
