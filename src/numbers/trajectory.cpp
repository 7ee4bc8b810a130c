// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/trajectory.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "numbers/errors.h"
#include "numbers/motion.h"
#include "numbers/rigidity.h"

namespace tricover {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void requireTime(double time) {
  if (std::isnan(time)) detail::refuse("time", "it is not a number", "give a time by the trajectory's clock");
}

void checkLegs(const std::vector<Leg>& legs) {
  if (legs.empty()) detail::refuse("legs", "a trajectory needs at least one");
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Leg& leg = legs[i];
    const auto name = [&] { return "legs[" + std::to_string(i) + "]"; };
    if (!(leg.begin < leg.end && std::isfinite(leg.end - leg.begin)))
      detail::refuse(name(), "it must end after its begin, both finite");
    if (i > 0 && leg.begin != legs[i - 1].end) detail::refuse(name(), "it must begin when the one before ends");
    checkMotion(leg.motion, (name() + ".motion").c_str());
  }
}

/// The first leg that ends later.
const Leg& legAt(const std::vector<Leg>& legs, double time) {
  return *std::upper_bound(legs.begin(), legs.end(), time, [](double at, const Leg& leg) { return at < leg.end; });
}

/// motionOf(i) from the time of timed[i - 1] to that of timed[i].
template <typename Timed, typename MotionOf>
std::vector<Leg> legsBetween(const std::vector<Timed>& timed, const char* name, MotionOf motionOf) {
  if (timed.size() < 2) detail::refuse(name, "a trajectory needs at least two");
  std::vector<Leg> legs;
  for (std::size_t i = 1; i < timed.size(); ++i) {
    const double length = timed[i].time - timed[i - 1].time;
    if (!(length > 0 && std::isfinite(length)))
      detail::refuse(name + ("[" + std::to_string(i)) + "].time", "times must be finite and increase");
    legs.push_back({timed[i - 1].time, timed[i].time, motionOf(i, length)});
  }
  return legs;
}

}  // namespace

Trajectory::Trajectory(std::vector<Leg> legs, const Pose& last) : legs_(std::move(legs)), last_(last) {}

Trajectory::Trajectory(std::vector<Leg> legs) : legs_(std::move(legs)) {
  checkLegs(legs_);
  last_ = legs_.back().motion.at(1);
}

Trajectory::Trajectory(const Pose& pose) : legs_{{0, 1, Motion::still(pose)}}, last_(pose), rests_(true) {
  detail::requireRigid(pose, "pose");
}

Trajectory Trajectory::through(const std::vector<TimedPose>& poses, const Vec2& pivot) {
  const auto name = [](std::size_t i) { return "poses[" + std::to_string(i) + "].pose"; };
  std::vector<Leg> legs = legsBetween(poses, "poses", [&](std::size_t i, double) {
    return detail::motionBetween(poses[i - 1].pose, name(i - 1), poses[i].pose, name(i), pivot);
  });
  return {std::move(legs), poses.back().pose};
}

Trajectory Trajectory::through(const std::vector<Waypoint>& waypoints, const Vec2& pivot) {
  detail::requireFinite(pivot, "pivot");
  const auto poseOf = [&](const Waypoint& waypoint) {
    return detail::poseOfPivot(waypoint.position, waypoint.angle, pivot);
  };
  std::vector<Leg> legs = legsBetween(waypoints, "waypoints", [&](std::size_t i, double) {
    const Waypoint &from = waypoints[i - 1], &to = waypoints[i];
    const Motion motion{poseOf(from), to.position - from.position, to.angle - from.angle, pivot};
    checkMotion(motion, ("waypoints[" + std::to_string(i) + "]").c_str());
    return motion;
  });
  return {std::move(legs), poseOf(waypoints.back())};
}

Trajectory Trajectory::spline(const std::vector<TimedKnot>& knots, const Vec2& pivot) {
  const auto inUnits = [](SplineEnd end, double length) {
    end.velocity *= length;
    end.angular_velocity *= length;
    return end;
  };
  std::vector<Leg> legs = legsBetween(knots, "knots", [&](std::size_t i, double length) {
    return Motion::spline(inUnits(knots[i - 1].end, length), inUnits(knots[i].end, length), pivot);
  });
  const SplineEnd& last = knots.back().end;
  return {std::move(legs), detail::poseOfPivot(last.position, last.angle, pivot)};
}

Trajectory Trajectory::appearing() const {
  Trajectory same = *this;
  same.appears_ = true;
  return same;
}

Trajectory Trajectory::vanishing() const {
  Trajectory same = *this;
  same.vanishes_ = true;
  return same;
}

double Trajectory::begin() const { return rests_ ? -kInfinity : legs_.front().begin; }
double Trajectory::end() const { return rests_ ? kInfinity : legs_.back().end; }

bool Trajectory::isThere(double time) const {
  requireTime(time);
  return (!appears_ || time >= begin()) && (!vanishes_ || time <= end());
}

Motion Trajectory::part(double from, double until) const {
  if (!(from < until)) detail::refuse("until", "it must be later than from");
  if (rests_ || from >= end()) return Motion::still(last_);
  if (until <= begin()) return Motion::still(legs_.front().motion.start);
  const Leg& leg = legAt(legs_, from);
  if (!(leg.begin <= from && until <= leg.end)) detail::refuse("until", "a leg begins or ends before it");
  const double length = leg.end - leg.begin;
  return leg.motion.part((from - leg.begin) / length, until == leg.end ? 1 : (until - leg.begin) / length);
}

Pose Trajectory::at(double time) const {
  requireTime(time);
  if (rests_ || time >= end()) return last_;
  if (time <= begin()) return legs_.front().motion.start;
  const Leg& leg = legAt(legs_, time);
  return leg.motion.at((time - leg.begin) / (leg.end - leg.begin));
}

}  // namespace tricover
