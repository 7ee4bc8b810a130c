// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tricover/export.h"
#include "tricover/time_of_impact.h"

namespace tricover {

/// An interval of time in which two moving polygons meet.
struct Conflict {
  Impact impact;  ///< Its begin, as timeOfImpact() reports it.
  /// At most ImpactOptions::time_error later than the last contact, and never earlier; 1 if that is where they meet
  /// last.
  double end;
  /// True if a search ended at its budget within this interval, which then reaches to 1. Contact before impact.time is
  /// excluded, but the polygons may be apart for parts of the interval.
  bool budget_ended = false;
  /// True if the polygons still meet at `end`, because time ends there, or a body jumps or vanishes; otherwise they are
  /// apart then.
  bool meets_at_end = false;
};

/// Returns all intervals of time from 0 to 1 in which two moving polygons meet: timeOfImpact(), and again after each
/// end. With a margin, these are the intervals in which the polygons are no farther apart than that. With
/// `ignore_initial`, an interval that begins at 0 is left out.
///
/// - Whenever the polygons meet, an interval says so. They are apart at each end below 1, as collide() says of both
///   poses, and from there as timeOfImpact() says. Coming within 1e-13 L counts as it does there.
/// - Whenever an interval says so, the polygons meet, or did or will by less than `time_error`. Being apart for less
///   than that may not be seen.
///
/// Intervals are in order and don't overlap. Contact that lasts is proven by the features in contact: an interval costs
/// some tens of collide()s, whatever `time_error` is.
///
/// The search has a budget: that of each timeOfImpact(), and some steps along contacts for each edge, and each radian
/// that the polygons rotate by. If one of these ends, the last interval reaches to 1 and has `budget_ended` set.
/// `ignore_initial` doesn't leave such an interval out. With a negative margin there are 2^14 steps, each as long as
/// the overlap stays as deep by its depth and the speed, or its deepest point stays so deep, or half a `time_error`:
/// enough but for an overlap that stays exactly as deep as is allowed while its deepest point changes.
///
/// A `time_error` below 1e-9 is taken for that.
///
/// \throws std::invalid_argument for a motion that checkMotion() refuses, for a margin that is not finite, and for a
/// time_error that is negative or not finite
///
/// \snippet time_of_impact.cpp conflicts
TRICOVER_EXPORT std::vector<Conflict> conflicts(const Polygon& a, const Motion& motion_a, const Polygon& b,
                                                const Motion& motion_b, const ImpactOptions& options = {});

/// Returns all time intervals in which the bodies meet. The last one ends at the last end of the two, if they meet
/// then, or where a body vanishes.
///
/// \throws std::invalid_argument for a margin that is not finite, for a time_error that is negative or not finite, and
/// for two bodies that always rest
///
/// \snippet trajectory.cpp trajectory
TRICOVER_EXPORT std::vector<Conflict> conflicts(const Polygon& a, const Trajectory& trajectory_a, const Polygon& b,
                                                const Trajectory& trajectory_b, const ImpactOptions& options = {});

}  // namespace tricover
