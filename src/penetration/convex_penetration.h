// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "penetration/separating_axes.h"

namespace tricover::detail {

/// The shortest translation of b that parts two convex sets which meet.
struct SupportGap {
  double depth;                ///< world length
  Vec2 normal;                 ///< unit, from a towards where b leaves
  bool edge_of_a;              ///< an edge of a and a corner of b part last; otherwise a corner of a and an edge of b
  std::uint32_t edge, corner;  ///< of the outlines
};

/// By separating axes, which are null unless both outlines have an area: the least support gap over the normals of both
/// polygons' convex outlines, O(n + m) as a rule; of those that are deeper by no more than `tie`, the one that leads
/// b's S away from a's. The gap is evaluated in double doubles from both unrounded poses, so its relative error is
/// below 1e-15 while it is above 1e-14 of the coordinates involved (world coordinates less what both translations
/// share), and below 2^-98 of them in any case.
SupportGap leastSupportGap(const PosedPair& pair, const SeparatingAxes* axes, double tie);

}  // namespace tricover::detail
