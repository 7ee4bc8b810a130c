// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "depth/inner_arcs.h"

namespace tricover::detail {

/// Part and area: where they meet, and the arcs of either one that the other one has. Of the part that is the inside,
/// of the area, whose distance is sought, what is outside of it.
struct Overlap {
  struct Area {
    const PolygonData& polygon;  ///< the area's edges; where the area is what is outside of it, its borders alone
    const Pose& pose;
    bool is_outside = false;  ///< whether the area is the closure of what is outside of the polygon
    /// Tells of a point in the world whether it is outside of the area, if the polygon doesn't.
    std::function<bool(const Vec2&)> excludes = nullptr;
  };

  Overlap(const PolygonData& part, const Pose& pose_part, const Area& area);
  Overlap(const Overlap&) = delete;
  Overlap& operator=(const Overlap&) = delete;

  /// What bounds may be apart by, in the frame.
  double precision() const { return 0x1p-50 * frame.size(); }

  const std::function<bool(const Vec2&)> excludes;
  const bool is_outside;
  const int part_side;  ///< the pair has the larger unit first
  const PosedPair pair;
  const WorldFrame frame;
  const std::vector<EdgeCrossing> crossings;
  const InnerArcs arcs[2];  ///< by side
};

/// The point of a part that is farthest from an area, in the world. An edge may be kNoEdge.
struct DeepestPoint {
  double distance = 0;
  Vec2 point = Vec2::Zero(), nearest = Vec2::Zero();
  Vec2 way = Vec2::UnitX();  ///< from the point to the nearest one, of length 1
  EdgePosition edge = kNoEdge, nearest_edge = kNoEdge;
  double upper_bound = 0;
};

/// The point of the part that is farthest from the area. Points that are no farther than `least` don't count. The
/// search ends as soon as a point is farther than `enough`. With `swaps`, of an area that is what is outside of its
/// polygon: the point of that polygon that is farthest from what is outside of the part, whose edges must all be
/// borders.
DeepestPoint findDeepestPoint(const Overlap& overlap, bool swaps, double least, double enough);

}  // namespace tricover::detail
