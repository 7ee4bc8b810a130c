// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "tricover/conflicts.h"
#include "tricover/export.h"
#include "tricover/motion.h"
#include "tricover/time_of_impact.h"

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

/// How a body moves, leg after leg, each a Motion, by a clock of the caller's: seconds, say. Before its begin and after
/// its end it rests, or is absent (ImpactOptions::absent_outside). It never changes.
///
/// \snippet trajectory.cpp trajectory
class TRICOVER_EXPORT Trajectory {
 public:
  /// Makes a trajectory from at least one leg. Each leg begins when the one before ends. A leg may begin at another
  /// pose: a body that jumps meets nothing on the jump.
  /// \throws std::invalid_argument for no leg, for other times, and for a motion that checkMotion() refuses. The text
  /// has the leg.
  explicit Trajectory(std::vector<Leg> legs);

  /// From pose to pose, as Motion::between() says, which waits where two are the same.
  /// \throws std::invalid_argument for fewer than two, for times that don't increase, and as Motion::between() does.
  /// The text has the waypoint, as in "poses[2].pose".
  static Trajectory through(const std::vector<TimedPose>& poses, const Vec2& pivot = Vec2::Zero());
  /// A cubic Hermite spline from knot to knot, as Motion::spline() says.
  /// \throws std::invalid_argument for fewer than two, for times that don't increase, and as Motion::spline() does
  static Trajectory spline(const std::vector<TimedKnot>& knots, const Vec2& pivot = Vec2::Zero());

  const std::vector<Leg>& legs() const { return legs_; }  ///< In order.
  double begin() const { return legs_.front().begin; }    ///< When it begins.
  double end() const { return legs_.back().end; }         ///< When it ends.
  /// The pose at any time, rounded; infinity is a time, too.
  /// \throws std::invalid_argument for NaN
  Pose at(double time) const;
  /// Returns the motion from one time to a later one, between which no leg ends. Its time 0 is `from`, and 1 is
  /// `until`.
  /// \throws std::invalid_argument for a time that isn't later, and where a leg begins or ends between them
  Motion part(double from, double until) const;

 private:
  std::vector<Leg> legs_;
};

/// The first contact of two bodies on their trajectories, from the first begin to the last end of the two; with
/// `absent_outside`, from the last begin to the first end. All is as for two motions; times, and `time_error`, are the
/// trajectories' own.
///
/// \throws std::invalid_argument for a margin that is not finite, and for a time_error that is negative or not finite
///
/// \snippet trajectory.cpp trajectory
TRICOVER_EXPORT std::optional<Impact> timeOfImpact(const Polygon& a, const Trajectory& trajectory_a, const Polygon& b,
                                                   const Trajectory& trajectory_b, const ImpactOptions& options = {});

/// Returns all time intervals in which the bodies meet. The last one ends at the last end of the two, if they meet
/// then; with `absent_outside`, at the first end.
///
/// \throws std::invalid_argument for a margin that is not finite, and for a time_error that is negative or not finite
///
/// \snippet trajectory.cpp trajectory
TRICOVER_EXPORT std::vector<Conflict> conflicts(const Polygon& a, const Trajectory& trajectory_a, const Polygon& b,
                                                const Trajectory& trajectory_b, const ImpactOptions& options = {});

}  // namespace tricover
