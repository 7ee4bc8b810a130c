// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "tricover/motion.h"
#include "tricover/polygon.h"

namespace tricover {

/// How exact a time of impact has to be.
struct ImpactOptions {
  /// How much earlier than the first contact an impact may be reported, as a share of the motion (time runs 0 to 1).
  double time_error = 1e-6;
};

/// The first contact of two motions.
struct Impact {
  double time;  ///< never later than the first contact, at most time_error earlier
  /// The middle between the nearest points of the two edges at that time, in the world. Of regions that overlap at time
  /// 0, which are deeper in each other than an edge tells: a common point.
  Vec2 point;
  Vec2 normal;  ///< unit, from a to b; of regions that overlap at time 0 it need not be the shortest way out
  /// The edge of a that comes together with b's, numbered as in Polygon::edgeStart; in a containment at time 0 -1 for
  /// the polygon whose inside holds the point.
  std::ptrdiff_t edge_a;
  std::ptrdiff_t edge_b;  ///< likewise of b
};

/// The first contact of two polygons that move, if there is one at a time from 0 to 1, both included; time 0 exactly
/// where collide() is true of the starts. Never misses one, however fast and thin. Coming within 1e-13 L may be
/// reported like contact, L the sum of the starts' distance (of their translations) and for either polygon of |shift|,
/// |pivot| and 1 + |angle| times its points' largest distance from the pivot; without a turn, origin() stands for the
/// pivot. Beyond 1e307 whatever may come near may be reported.
/// Symmetric. The cost grows with the number of turns near each other.
/// Throws std::invalid_argument for motions that checkMotion() refuses and a time_error that is negative or not finite.
std::optional<Impact> timeOfImpact(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b,
                                   const ImpactOptions& options = {});

}  // namespace tricover
