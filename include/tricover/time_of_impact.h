// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "tricover/export.h"
#include "tricover/impact.h"
#include "tricover/motion.h"
#include "tricover/polygon.h"
#include "tricover/trajectory.h"

namespace tricover {

/// Returns the first contact of two moving polygons at a time from 0 to 1, both included, or nothing if there is none.
/// With a margin, that is the first time at which they are no farther apart than the margin.
///
/// No contact is missed, however fast and thin the polygons are. The time is 0 exactly where collide(), with the same
/// margin, is true of the two starts. Swapping the operands swaps the edges and turns the normal round,
/// unless they are the same region that moves alike.
///
/// Coming within 1e-13 L may be reported like a contact. L is the sum of
/// - the margin and the distance between the two starts' translations,
/// - for either polygon |shift|, |pivot|, and (1 + |angle|) times the largest distance of its points from the pivot,
///   where |shift| and |angle| stand for the sums of all their terms' sizes.
///
/// (For a polygon that doesn't turn, read coveringOrigin() for the pivot.) Where L exceeds 1e307, whatever may come
/// near may be reported.
///
/// The cost grows with the number of turns that the polygons make near each other. The search has a budget, which grows
/// with the number of edges. It lasts for all but contrived inputs: thousands of edges that come near thousands of
/// others, or outlines that stay within rounding of each other. If it ends, the result is an impact
/// at the time before which contact is excluded, with `budget_ended` set.
///
/// With a negative margin, an overlap within 2e-13 L of the allowed one may be reported like a deeper one. The result
/// is never later than the first time at which the regions are as deep. No point of a piece of an outline is deep for
/// as long as the piece, translated by no more than is allowed, has no contact: times of impact as above. Each piece
/// has a translation of its own, and is halved where it finds none. Where pieces would be short, the search goes on for
/// as long as the depth takes to become what is allowed. After 4096 steps the result has `budget_ended` set.
///
/// \throws std::invalid_argument for a motion that checkMotion() refuses, for a margin that is not finite, and for a
/// time_error that is negative or not finite
///
/// \snippet time_of_impact.cpp time of impact
/// \snippet time_of_impact.cpp allowed overlap
TRICOVER_EXPORT std::optional<Impact> timeOfImpact(const Polygon& a, const Motion& motion_a, const Polygon& b,
                                                   const Motion& motion_b, const ImpactOptions& options = {});

/// The first contact of two bodies on their trajectories, from the first begin to the last end of the two, while both
/// are there. All is as for two motions; times, and `time_error`, are the trajectories' own.
///
/// \throws std::invalid_argument for a margin that is not finite, for a time_error that is negative or not finite, and
/// for two bodies that always rest
///
/// \snippet trajectory.cpp trajectory
TRICOVER_EXPORT std::optional<Impact> timeOfImpact(const Polygon& a, const Trajectory& trajectory_a, const Polygon& b,
                                                   const Trajectory& trajectory_b, const ImpactOptions& options = {});

}  // namespace tricover
