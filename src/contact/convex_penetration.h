// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "contact/convex_outline.h"
#include "polygon/polygon_data.h"

namespace tricover::detail {

/// The shortest translation of b that parts two convex sets which meet.
struct SupportGap {
  double depth;    ///< world length
  Vec2 direction;  ///< unit, from a towards where b leaves
  bool edge_of_a;  ///< an edge of a and a corner of b part last; otherwise a corner of a and an edge of b
  std::size_t edge_start, edge_end, corner;  ///< positions in the paths
};

/// By separating axes: the least support gap over the normals of both outlines, O(n + m). The gap is evaluated in
/// double doubles from both unrounded poses, so its relative error is below 1e-15 while it is above 1e-14 of the
/// coordinates involved (world coordinates less what both translations share), and below 2^-98 of them in any case.
SupportGap leastSupportGap(const PolygonData& a, const Pose& pose_a, const ConvexOutline& outline_a,
                           const PolygonData& b, const Pose& pose_b, const ConvexOutline& outline_b);

}  // namespace tricover::detail
