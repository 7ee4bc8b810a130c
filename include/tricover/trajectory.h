// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tricover/export.h"
#include "tricover/motion.h"

namespace tricover {

/// A part of a Trajectory.
struct Leg {
  double begin;   ///< When it begins,
  double end;     ///< and when it ends, which is later.
  Motion motion;  ///< Time 0 of it is `begin`, and 1 is `end`.
};

/// Where a body is at a time.
struct TimedPose {
  double time;  ///< When.
  Pose pose;    ///< Where, from the polygon's frame to the world.
};

/// Where a body is at a time, and how it moves there: rates are by the trajectory's time.
struct TimedKnot {
  double time;    ///< When.
  SplineEnd end;  ///< Where, and how it moves there.
};

/// Where a body's pivot is at a time, and its heading then.
struct Waypoint {
  double time;    ///< When.
  Vec2 position;  ///< The pivot, in the world.
  double angle;   ///< The body's heading: radians, counter-clockwise, any number of turns.
};

/// How a body moves, leg after leg, each a Motion, by a clock of the caller's: seconds, say. Before its begin it rests
/// where it begins, unless it appears() then; after its end it rests where it ends, unless it vanishes() then. It never
/// changes.
///
/// \snippet trajectory.cpp trajectory
class TRICOVER_EXPORT Trajectory {
 public:
  /// Makes a trajectory from at least one leg. Each leg begins when the one before ends. A leg may begin at another
  /// pose: a body that jumps meets nothing on the jump.
  /// \throws std::invalid_argument for no leg, for other times, and for a motion that checkMotion() refuses. The text
  /// has the leg.
  explicit Trajectory(std::vector<Leg> legs);
  /// Makes the trajectory of a body that rests at a pose, always: beside another one, the other's begin and end count.
  /// \throws std::invalid_argument for a pose that checkPose() refuses
  /// \snippet trajectory.cpp appears
  Trajectory(const Pose& pose);

  /// From pose to pose by the shorter rotation, as Motion::between() says. It waits where two are the same, and rests
  /// at the last one exactly.
  /// \throws std::invalid_argument for fewer than two, for times that don't increase, and as Motion::between() does.
  /// The text has the waypoint, as in "poses[2].pose".
  static Trajectory through(const std::vector<TimedPose>& poses, const Vec2& pivot = Vec2::Zero());
  /// From waypoint to waypoint, on straight lines. It rotates by the angles given, as spline() does: from 0 to 6 is
  /// nearly a full turn.
  /// \throws std::invalid_argument for fewer than two, for times that don't increase, and for a value that is not
  /// finite
  /// \snippet trajectory.cpp waypoints
  static Trajectory through(const std::vector<Waypoint>& waypoints, const Vec2& pivot = Vec2::Zero());
  /// A cubic Hermite spline from knot to knot, as Motion::spline() says. It rests at the last one exactly.
  /// \throws std::invalid_argument for fewer than two, for times that don't increase, and as Motion::spline() does
  static Trajectory spline(const std::vector<TimedKnot>& knots, const Vec2& pivot = Vec2::Zero());

  /// Returns the same trajectory of a body that is absent before it begins, and meets nothing then.
  /// \snippet trajectory.cpp appears
  Trajectory appearing() const;
  /// Returns the same trajectory of a body that is absent after it ends, and meets nothing then.
  /// \snippet trajectory.cpp appears
  Trajectory vanishing() const;

  const std::vector<Leg>& legs() const { return legs_; }  ///< In order. One that waits, where the body always rests.
  bool rests() const { return rests_; }                   ///< Whether it was made of a pose.
  bool appears() const { return appears_; }               ///< Whether the body is absent before the begin.
  bool vanishes() const { return vanishes_; }             ///< Whether the body is absent after the end.
  double begin() const;  ///< When it begins; minus infinity where the body always rests.
  double end() const;    ///< When it ends; infinity where the body always rests.
  /// Whether the body is there. It is at its begin and at its end.
  /// \throws std::invalid_argument for NaN
  bool isThere(double time) const;
  /// The pose at any time, rounded; infinity is a time, too. Outside of its time, where it would rest.
  /// \throws std::invalid_argument for NaN
  Pose at(double time) const;
  /// Returns the motion from one time to a later one, between which no leg ends. Its time 0 is `from`, and 1 is
  /// `until`.
  /// \throws std::invalid_argument for a time that isn't later, and where a leg begins or ends between them
  Motion part(double from, double until) const;

 private:
  Trajectory(std::vector<Leg> legs, const Pose& last);

  std::vector<Leg> legs_;
  Pose last_;  ///< where it ends
  bool rests_ = false, appears_ = false, vanishes_ = false;
};

}  // namespace tricover
