// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "contact/hull_faces.h"
#include "contact/overlap_components.h"
#include "contact/separating_axes.h"

namespace tricover::detail {

/// The way that takes b out of a past one part of their overlap, in the WorldFrame, edges by position.
struct Exit {
  Vec2 normal = Vec2::UnitX();
  double depth = std::numeric_limits<double>::infinity();
  std::ptrdiff_t edge_a = -1, edge_b = -1;
  bool from_a = true;  ///< a's face, and a point of b is the deepest behind it; or the other way round
};

/// Of a containment it is a vertex of what is inside.
const BoundaryPoint& leftmostOf(const OverlapComponent& component);

/// Of each part by itself, as if it and the edges around it were all there is.
class PartExits {
 public:
  PartExits(const PosedPair& pair, const WorldFrame& frame, const std::vector<EdgeCrossing>& crossings)
      : pair_(pair), frame_(frame), crossings_(crossings), towards_b_(-frame.originOfA()) {}

  /// Until the next call.
  const Hull& hullOf(const OverlapComponent& component) {
    // The second time, other points are beside those that are left.
    const double same_area = 2 * frame_.error() * frame_.size();
    return part_ = detail::hullOf(likelyCorners(likelyCorners(component.points, same_area), same_area));
  }
  /// Of the component whose hull was asked for last.
  Exit exitOf(const OverlapComponent& component);
  /// The only part of two convex regions: the least depth of their separating axes, which no translation that parts
  /// them is shorter than.
  Exit exitOfConvex(const OverlapComponent& component, const SeparatingAxes& axes) const;

 private:
  bool isBetter(const Exit& exit, const Exit& best) const;
  std::ptrdiff_t flatterOfA(const BoundaryPoint& p, const Vec2& normal) const;
  std::ptrdiff_t flatterOfB(const BoundaryPoint& p, const Vec2& normal) const;
  BoundaryPoint vertexOfA(std::size_t v) const { return vertexPoint(pair_.a, 0, v, frame_.fromA(pair_.a.path[v])); }
  BoundaryPoint vertexOfB(std::size_t v) const { return vertexPoint(pair_.b, 1, v, frame_.fromB(pair_.b.path[v])); }
  Hull grownPart(const OverlapComponent& component, bool of_a) const;
  struct Found {
    Exit exit;
    const BoundaryPoint *from = nullptr, *to = nullptr, *deepest = nullptr;  ///< the face, and what is behind it
  };
  Found leastFace(bool is_edge) const;
  Exit byFaces(const OverlapComponent& component);
  void completeEdges(const OverlapComponent& component, Exit& exit) const;
  Exit ofTouch(const OverlapComponent& component) const;
  Polygon ringsOf(const OverlapComponent& component, bool of_b) const;
  Exit byNearestEdge(const OverlapComponent& component) const;

  const PosedPair& pair_;
  const WorldFrame& frame_;
  const std::vector<EdgeCrossing>& crossings_;
  Vec2 towards_b_;
  Hull part_, grown_[2];
};

}  // namespace tricover::detail
