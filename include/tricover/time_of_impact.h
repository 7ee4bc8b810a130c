// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "tricover/export.h"
#include "tricover/motion.h"
#include "tricover/polygon.h"

namespace tricover {

/// How exact a time of impact has to be.
struct ImpactOptions {
  /// A world length, finite. An impact is the first time at which the polygons are no farther apart than this. With a
  /// negative margin of -e it is the first time at which they are at least e deep in each other, as collide() with that
  /// margin says: bodies that rest on each other slide and leave freely.
  double margin = 0;
  /// How much earlier than the first contact an impact may be reported. Time runs from 0 to 1.
  double time_error = 1e-6;
  /// If true, polygons that collide at time 0, with the margin, have no impact before they have separated once. The
  /// search may miss a separation shorter than `time_error` (or 1e-9, if that is more).
  bool ignore_initial = false;
  /// If true, a body of a trajectory is absent before its trajectory begins and after it ends. Otherwise it rests
  /// there. A body that has no trajectory of its own is always there.
  bool absent_outside = false;
};

/// The first contact of two motions, in the world.
struct Impact {
  /// Never later than the first contact; earlier by at most ImpactOptions::time_error than the polygons come within the
  /// precision that timeOfImpact() names.
  double time;
  /// The middle between the nearest points of the two edges at that time, or a common point of regions that overlap at
  /// time 0.
  Vec2 point;
  /// A unit vector from a to b. For regions that overlap at time 0 it may differ from the shortest separating
  /// translation.
  Vec2 normal;
  EdgeIndex edge_a;  ///< The edge of a that meets b's. -1 where b lies inside a at time 0.
  EdgeIndex edge_b;  ///< The edge of b that meets a's. -1 where a lies inside b at time 0.
  /// True if the search ended at its budget. Contact before `time` is excluded; whether the polygons meet then, later
  /// or at all is unknown. The edges are two that may meet, and the point lies between them.
  bool budget_ended = false;
};

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
/// (For a polygon that doesn't turn, read origin() for the pivot.) Where L exceeds 1e307, whatever may come near may be
/// reported.
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

}  // namespace tricover
