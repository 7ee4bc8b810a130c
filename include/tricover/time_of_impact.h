// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "tricover/motion.h"
#include "tricover/polygon.h"

namespace tricover {

struct ImpactOptions {
  /// How much earlier than the first contact an impact may be reported, as a share of the motion (time runs 0 to 1).
  double time_error = 1e-6;
};

struct Impact {
  double time;  ///< never later than the first contact, at most time_error earlier
  /// Near contact at that time: the middle between the nearest points, in the world, and a unit normal from a to b.
  Vec2 point, normal;
  std::ptrdiff_t edge_a, edge_b;  ///< the edges that come together, numbered as in Polygon::edgeStart; -1 as in Contact
};

/// The first contact of two polygons that move, if there is one at a time from 0 to 1, both included. Never misses one;
/// TOLERANCE-STATEMENT. collide() at time 0 gives time 0.
/// Throws std::invalid_argument for motions that checkMotion() refuses and a time_error that is negative or not finite.
std::optional<Impact> timeOfImpact(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b,
                                   const ImpactOptions& options = {});

}  // namespace tricover
