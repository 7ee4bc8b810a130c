// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "impact/moving_pair.h"
#include "numbers/march.h"
#include "tricover/conflicts.h"
#include "tricover/depth.h"
#include "tricover/least_distance.h"
#include "tricover/trajectory.h"

namespace tricover::detail {

/// Two moving polygons: when contact ends, and when it begins again. What comes within 8 of MovingPair::error touches:
/// less is not known of where they are, and contact that lasts is proven by features that stay so near.
class MovingContact {
 public:
  /// Takes arguments that have been checked; `options` are for time from 0 to 1.
  MovingContact(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b,
                const ImpactOptions& options);

  /// Returns when polygons are apart again that met, or were about to, at `begin`, by half of time_error too late at
  /// most; 1 if they meet until then. It is unknown if the steps ended before the contact did.
  Reached endOfContact(double begin);

  /// Returns the first contact from `begin` on, where they are apart unless it is 0.
  std::optional<Impact> next(double begin) const;

  /// Whether they touch at a time; with a negative margin, whether they are as deep in each other.
  bool touchAt(double time) const;

  /// How far points may be from where they are said to be, a world length.
  double precision() const { return precision_; }
  /// No point of one polygon moves faster against the other one.
  double speed() const { return speed_; }
  /// With a negative margin, the first contact that is as deep.
  std::optional<Impact> deepImpact() const;

 private:
  struct Posed;
  const Depth& depthAt(double time) const;  ///< with a negative margin
  bool meetUntil(double time, double next) const;
  bool featuresStay(double time, double next) const;
  bool staysContained(double time, double next, double travel) const;
  bool staysDeep(double time, double next, double at) const;

  const Polygon &a_, &b_;
  const Motion &motion_a_, &motion_b_;
  const MovingPair pair_;
  const double margin_, seen_;  ///< begins are told so much too early, and ends so much too late, at most
  double precision_;            ///< of where points are
  double touch_margin_;         ///< within which they touch
  mutable std::pair<double, Depth> depths_[2];  ///< the last times and depths
  mutable std::optional<Polygon> walls_[2];     ///< the borders of a, and of b, as segments
  double speed_;                                ///< no point of one moves faster against the other one
  int steps_left_;                              ///< of endOfContact(), for all contacts together
};

/// Adds the conflicts of motions that go on from `begin` to `end`, by the clock of all that is given and found. If
/// `leaves_out`, contact that lasts from the begin is left out; then that says whether it lasts to the end.
void addConflicts(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b, double begin,
                  double end, const ImpactOptions& options, bool& leaves_out, std::vector<Conflict>& all);

/// When two bodies are there together, from the first begin to the last end of the two; `begin` is later than `end` if
/// they never are. Throws for two that always rest.
struct TimeTogether {
  double begin, end;
};
TimeTogether timeTogether(const Trajectory& a, const Trajectory& b);

/// timeOfImpact() and conflicts() of trajectories, with options that have been checked.
std::optional<Impact> timeOfImpact(const Polygon& a, const Trajectory& trajectory_a, const Polygon& b,
                                   const Trajectory& trajectory_b, const ImpactOptions& options);
std::vector<Conflict> conflicts(const Polygon& a, const Trajectory& trajectory_a, const Polygon& b,
                                const Trajectory& trajectory_b, const ImpactOptions& options);

/// Throws as leastDistance() does.
void checkOptions(const LeastDistanceOptions& options);

}  // namespace tricover::detail
