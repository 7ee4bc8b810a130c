// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/export.h"
#include "tricover/motion.h"
#include "tricover/polygon.h"
#include "tricover/trajectory.h"

namespace tricover {

/// The options of leastDistance().
struct LeastDistanceOptions {
  double margin = 0;             ///< A world length, at least 0 and finite, which is subtracted from the distance.
  double absolute_error = 1e-6;  ///< A world length, positive: how much more than the least one the distance may be.
};

/// The least distance of two moving bodies, in the world.
struct LeastDistance {
  double distance;     ///< At that time, less the margin; 0 if they meet, or come within the margin.
  double lower_bound;  ///< No distance on the way is less, but for rounding: at most the error below `distance`.
  double time;         ///< When: of several times, any.
  Vec2 point_a;        ///< The point of a nearest to b at that time.
  Vec2 point_b;        ///< The point of b nearest to a at that time.
  EdgeIndex edge_a;    ///< The edge of a that point_a lies on; -1 as in DistanceResult.
  EdgeIndex edge_b;    ///< The edge of b that point_b lies on; -1 as in DistanceResult.
  bool budget_ended;   ///< True if a search ended at its budget: then the lower bound may be less than that.
};

/// Returns the least distance of two moving polygons at a time from 0 to 1, both included, with when and where it is.
///
/// Each impact with a margin proves a bound: bodies come within a margin, or they never do. The search goes to a
/// minimum by distances, which it proves then. It costs about as much as some tens of distance() and a few
/// timeOfImpact(), whatever the error is; where minima are many, at most twice timeOfImpact() for each bit of
/// distance / error.
///
/// \throws std::invalid_argument for a motion that checkMotion() refuses, for a margin that is negative or not finite,
/// and for an error that is not finite and positive
///
/// \snippet time_of_impact.cpp least distance
TRICOVER_EXPORT LeastDistance leastDistance(const Polygon& a, const Motion& motion_a, const Polygon& b,
                                            const Motion& motion_b, const LeastDistanceOptions& options = {});

/// Returns the same along trajectories, from the first begin to the last end of the two, while both bodies are there.
/// Times are the trajectories' own.
///
/// \throws std::invalid_argument for a margin that is negative or not finite, for an error that is not finite and
/// positive, for bodies that are never there together, and for two that always rest
///
/// \snippet time_of_impact.cpp least distance
TRICOVER_EXPORT LeastDistance leastDistance(const Polygon& a, const Trajectory& trajectory_a, const Polygon& b,
                                            const Trajectory& trajectory_b, const LeastDistanceOptions& options = {});

}  // namespace tricover
