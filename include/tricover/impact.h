// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

}  // namespace tricover
