// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "tricover/polygon.h"

namespace tricover {

/// How much a penetration may cost.
struct PenetrationOptions {
  /// How many poses may be tried for a pair that isn't convex (the last step may take some more). 0 tries none: the
  /// bound by the two convex hulls is left.
  std::size_t budget = 20000;
};

/// The shortest translation of b that parts two regions which overlap, in the world.
struct Penetration {
  /// Its length, at whose end they still touch. An upper bound in any case. Infinity where lengths overflow or the
  /// coordinates are rounded by more than the polygons' size; there are then no translation, points and edges (-1).
  double depth;
  Vec2 direction;      ///< unit, from a towards where b leaves it
  double lower_bound;  ///< no shorter translation parts them, but into a slit narrower than the precision below
  bool optimal;        ///< depth and lower_bound agree to that precision: the budget sufficed
  /// Of b, or its opposite of a: proven to part them, rounding of pose.translation() + translation included. Longer
  /// than depth * direction, and off it, by as little as that takes.
  Vec2 translation;
  /// On a's surface, where they part last, as it is now. If optimal, point_a is point_b + depth * direction; otherwise
  /// near it.
  Vec2 point_a;
  Vec2 point_b;           ///< likewise on b's
  std::ptrdiff_t edge_a;  ///< that point_a lies on (numbered as in Polygon::edgeStart)
  std::ptrdiff_t edge_b;  ///< likewise of b
};

/// Nothing if the regions are apart; otherwise the greatest lower bound of the translations after which they are: the
/// global one, holes and gaps included (b may leave into a hole). It is 0 where they only touch, unless they are wedged
/// there: a peg exactly as wide as its slot has to leave through the mouth.
///
/// Precision: of a convex pair, 1e-15 of depth itself while that is above 1e-14 of the coordinates; of others, 1e-12 of
/// the smaller radius() plus 1e-13 of both and of the distance between the poses' translations.
/// Cost: of a convex pair, O(n + m) (3 us for 8 vertices each, 20 us for 64); of others, a search: for 64 vertices each
/// typically 15 to 40 us where they overlap by little and 0.3 to 1 ms where by a third of their size, for 1024 vertices
/// up to 0.2 s. Outlines that are nearly but not quite parallel over a long way may exhaust the budget.
/// Swapping the operands gives the same depth and the opposite direction. Throws std::invalid_argument as collide()
/// does.
std::optional<Penetration> penetration(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                                       const PenetrationOptions& options = {});

}  // namespace tricover
