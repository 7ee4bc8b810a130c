// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "tricover/polygon.h"

namespace tricover {

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
  Vec2 translation;
  /// Surface points that part last: point_a on a, point_b on b, point_a = point_b + depth * direction, rounded.
  Vec2 point_a, point_b;
  std::ptrdiff_t edge_a, edge_b;  ///< they lie on (numbered as in Polygon::edgeStart)
};

/// Nothing if the regions are apart; depth 0 where they only touch. The global optimum, holes and gaps included: b may
/// leave into a hole. Convex pairs cost O(n + m); others see penetration.cpp's head.
/// Throws std::invalid_argument as collide() does.
std::optional<Penetration> penetration(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                                       const PenetrationOptions& options = {});

}  // namespace tricover
