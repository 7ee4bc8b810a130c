// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "contact/component_hull.h"
#include "contact/overlap_components.h"
#include "contact/shortest_exit.h"
#include "penetration/separating_axes.h"

namespace tricover::detail {

/// The translation that takes b out of a past one component of their overlap, in the WorldFrame.
struct Exit {
  Vec2 normal = Vec2::UnitX();
  double depth = std::numeric_limits<double>::infinity();
  EdgePosition edges[2] = {kNoEdge, kNoEdge};
  int face = 0;  ///< the side whose face it leads across: a point of the other is deepest behind it
};

/// In a containment a vertex of the inner polygon.
const BoundaryPoint& leftmostOf(const OverlapComponent& component);

/// The crossing of a component whose edges have the longest interval in common.
std::size_t longestStretch(const WorldFrame& frame, const std::vector<EdgeCrossing>& crossings,
                           const OverlapComponent& component);

/// The exit of each component by itself, as if it and the edges around it were all there is.
class ComponentExits {
 public:
  ComponentExits(const PosedPair& pair, const WorldFrame& frame, const std::vector<EdgeCrossing>& crossings)
      : pair_(pair), frame_(frame), crossings_(crossings), towards_b_(-frame.originOfA()) {}

  /// Until the next call.
  const Hull& hullOf(const OverlapComponent& component) { return hull_ = detail::hullOf(component.points); }
  /// Of the component whose hull was asked for last.
  Exit exitOf(const OverlapComponent& component);
  /// The only component of two convex regions: the least depth of their separating axes, which no translation that
  /// separates them is shorter than.
  Exit exitOfConvex(const OverlapComponent& component, const SeparatingAxes& axes) const;

 private:
  EdgePosition flatter(int side, const BoundaryPoint& p, const Vec2& normal) const;
  EdgePosition edgeOf(const OutlinePiece& piece, const Vec2& normal) const;
  Exit byOutlines(const OverlapComponent& component) const;
  void completeEdges(const OverlapComponent& component, Exit& exit) const;
  Exit ofTouch(const OverlapComponent& component) const;
  Vec2 normalOfTouch(const OverlapComponent& component, const EdgeCrossing& main) const;
  std::vector<Vec2> directionsFrom(const OverlapComponent& component, const EdgeCrossing& main) const;
  Polygon ringsOf(const OverlapComponent& component, int side) const;
  Exit byNearestEdge(const OverlapComponent& component) const;

  const PosedPair& pair_;
  const WorldFrame& frame_;
  const std::vector<EdgeCrossing>& crossings_;
  Vec2 towards_b_;
  Hull hull_;
};

}  // namespace tricover::detail
