// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "depth/inner_arcs.h"

namespace tricover::detail {

/// What two regions have in common, or what one of them has outside of the other one.
struct Overlap {
  /// The pair, that with the larger unit first. `is_a_inside`: whether what is inside of a is sought, or else outside;
  /// of a polygon that is a part, the inside.
  Overlap(const PolygonData& a, const Pose& pose_a, bool is_a_inside, const PolygonData& b, const Pose& pose_b,
          bool is_b_inside)
      : is_swapped(a.unit < b.unit),
        pair(is_swapped ? PosedPair(b, pose_b, a, pose_a) : PosedPair(a, pose_a, b, pose_b)),
        frame(pair),
        is_sought_inside{is_swapped ? is_b_inside : is_a_inside, is_swapped ? is_a_inside : is_b_inside},
        crossings(findCrossings(pair, frame)),
        arcs{{pair, frame, crossings, 0, is_sought_inside[1]}, {pair, frame, crossings, 1, is_sought_inside[0]}} {}
  Overlap(const Overlap&) = delete;
  Overlap& operator=(const Overlap&) = delete;

  const bool is_swapped;
  const PosedPair pair;
  const WorldFrame frame;
  const bool is_sought_inside[2];  ///< by side
  const std::vector<EdgeCrossing> crossings;
  const InnerArcs arcs[2];  ///< of each side, in what is sought of the other
};

/// The point of a part that is farthest from an area, in the world. Edges are positions, or -1.
struct DeepestPoint {
  double distance = 0;
  Vec2 point = Vec2::Zero(), nearest = Vec2::Zero();
  std::ptrdiff_t edge = -1, nearest_edge = -1;
  double upper_bound = 0;
};

/// The point of one side, the part, that is deepest in what is sought of the other one, the area's outside. Points that
/// are no farther than `least` from the area don't count. The search ends as soon as a point is farther than `enough`.
DeepestPoint findDeepestPoint(const Overlap& overlap, int part_side, double least, double enough);

}  // namespace tricover::detail
