// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "tricover/polygon.h"

namespace tricover {

/// How much a penetration may cost.
struct PenetrationOptions {
  /// How many poses may be tried for a pair that isn't convex; 0 tries none but the bounds that cost nothing.
  std::size_t budget = 20000;
};

/// The shortest translation that parts two regions which overlap, in the world.
struct Penetration {
  /// Moving b by (depth * (1 + 1e-12) + tiny) * direction parts them: an upper bound of the shortest way in any case.
  double depth;
  Vec2 direction;      ///< unit, from a towards where b leaves it
  double lower_bound;  ///< no translation that is shorter parts them
  bool optimal;        ///< depth is the shortest to within 1e-12 of the smaller polygon's radius: the budget sufficed
  Vec2 translation;    ///< of b, in the world: parts them, rounding included
  /// On a's surface, where they part last: point_a = point_b + depth * direction, rounded.
  Vec2 point_a;
  Vec2 point_b;           ///< likewise on b's
  std::ptrdiff_t edge_a;  ///< that point_a lies on (numbered as in Polygon::edgeStart)
  std::ptrdiff_t edge_b;  ///< likewise of b
};

/// Nothing if the regions are apart; depth 0 where they only touch. The global optimum, holes and gaps included: b may
/// leave into a hole. Convex pairs cost O(n + m); others see penetration.cpp's head.
/// Throws std::invalid_argument as collide() does.
std::optional<Penetration> penetration(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                                       const PenetrationOptions& options = {});

}  // namespace tricover
