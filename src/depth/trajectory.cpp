// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/trajectory.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "depth/conflicts.h"
#include "impact/impact_options.h"
#include "numbers/errors.h"

namespace tricover {
namespace {

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

/// visit(motion of a, motion of b, begin, end), in order, between all times at which a leg of either one ends, while
/// both bodies are there, until it returns false. Bodies that are there together for an instant stand still in it.
template <typename Visit>
void forEachInterval(const detail::TimedBody& a, const detail::TimedBody& b, Visit visit) {
  std::vector<double> times;
  times.reserve(a.trajectory.legs().size() + b.trajectory.legs().size() + 2);
  double begin = -std::numeric_limits<double>::infinity(), end = -begin;
  for (const detail::TimedBody* body : {&a, &b}) {
    times.push_back(body->trajectory.begin());
    for (const Leg& leg : body->trajectory.legs()) times.push_back(leg.end);
    if (!body->absent_outside) continue;
    begin = std::max(begin, body->trajectory.begin());
    end = std::min(end, body->trajectory.end());
  }
  if (begin == end) {
    visit(Motion::still(a.trajectory.at(begin)), Motion::still(b.trajectory.at(begin)), begin, end);
    return;
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double from = times[i - 1], until = times[i];
    if (from < begin || until > end) continue;
    if (!visit(a.trajectory.part(from, until), b.trajectory.part(from, until), from, until)) return;
  }
}

}  // namespace

Trajectory::Trajectory(std::vector<Leg> legs) : legs_(std::move(legs)) { checkLegs(legs_); }

Trajectory Trajectory::through(const std::vector<TimedPose>& poses, const Vec2& pivot) {
  const auto name = [](std::size_t i) { return "poses[" + std::to_string(i) + "].pose"; };
  return Trajectory(legsBetween(poses, "poses", [&](std::size_t i, double) {
    return detail::motionBetween(poses[i - 1].pose, name(i - 1), poses[i].pose, name(i), pivot);
  }));
}

Trajectory Trajectory::spline(const std::vector<TimedKnot>& knots, const Vec2& pivot) {
  const auto inUnits = [](SplineEnd end, double length) {
    end.velocity *= length;
    end.angular_velocity *= length;
    return end;
  };
  return Trajectory(legsBetween(knots, "knots", [&](std::size_t i, double length) {
    return Motion::spline(inUnits(knots[i - 1].end, length), inUnits(knots[i].end, length), pivot);
  }));
}

Motion Trajectory::part(double from, double until) const {
  if (!(from < until)) detail::refuse("until", "it must be later than from");
  if (until <= begin()) return Motion::still(legs_.front().motion.start);
  if (from >= end()) return Motion::still(legs_.back().motion.at(1));
  const auto ends_later = [&](double time, const Leg& leg) { return time < leg.end; };
  const Leg& leg = *std::upper_bound(legs_.begin(), legs_.end(), from, ends_later);
  if (!(leg.begin <= from && until <= leg.end)) detail::refuse("until", "a leg begins or ends before it");
  const double length = leg.end - leg.begin;
  return leg.motion.part((from - leg.begin) / length, until == leg.end ? 1 : (until - leg.begin) / length);
}

Pose Trajectory::at(double time) const {
  if (std::isnan(time)) detail::refuse("time", "it is not a number", "give a time by the trajectory's clock");
  if (time <= begin()) return legs_.front().motion.start;
  if (time >= end()) return legs_.back().motion.at(1);
  const auto ends_later = [](double at, const Leg& leg) { return at < leg.end; };
  const Leg& leg = *std::upper_bound(legs_.begin(), legs_.end(), time, ends_later);
  return leg.motion.at((time - leg.begin) / (leg.end - leg.begin));
}

std::optional<Impact> detail::timeOfImpact(const Polygon& a, const TimedBody& body_a, const Polygon& b,
                                           const TimedBody& body_b, const ImpactOptions& options) {
  if (options.ignore_initial) {
    const std::vector<Conflict> all = conflicts(a, body_a, b, body_b, options);
    if (all.empty()) return std::nullopt;
    return all.front().impact;
  }
  std::optional<Impact> found;
  forEachInterval(body_a, body_b, [&](const Motion& motion_a, const Motion& motion_b, double begin, double end) {
    found = tricover::timeOfImpact(a, motion_a, b, motion_b, optionsWithin(options, end - begin));
    if (found) found->time = timeWithin(begin, end - begin, found->time);
    return !found;
  });
  return found;
}

std::vector<Conflict> detail::conflicts(const Polygon& a, const TimedBody& body_a, const Polygon& b,
                                        const TimedBody& body_b, const ImpactOptions& options) {
  std::vector<Conflict> all;
  bool leaves_out = options.ignore_initial;
  forEachInterval(body_a, body_b, [&](const Motion& motion_a, const Motion& motion_b, double begin, double end) {
    addConflicts(a, motion_a, b, motion_b, begin, end, options, leaves_out, all);
    return true;
  });
  return all;
}

std::optional<Impact> timeOfImpact(const Polygon& a, const Trajectory& trajectory_a, const Polygon& b,
                                   const Trajectory& trajectory_b, const ImpactOptions& options) {
  detail::checkOptions(options);
  return detail::timeOfImpact(a, {trajectory_a, options.absent_outside}, b, {trajectory_b, options.absent_outside},
                              options);
}

std::vector<Conflict> conflicts(const Polygon& a, const Trajectory& trajectory_a, const Polygon& b,
                                const Trajectory& trajectory_b, const ImpactOptions& options) {
  detail::checkOptions(options);
  return detail::conflicts(a, {trajectory_a, options.absent_outside}, b, {trajectory_b, options.absent_outside},
                           options);
}

}  // namespace tricover
