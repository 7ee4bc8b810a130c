// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "pair/world_frame.h"

namespace tricover::detail {

/// Part of an edge, from 0 at its start to 1 at its end.
struct Span {
  double low, high;
  double middle() const { return 0.5 * low + 0.5 * high; }
};

/// Two edges (positions in the paths) that share a point, and where, but for rounding: more than a point where they
/// are collinear.
struct EdgeCrossing {
  std::size_t edge_a, edge_b;
  Span on_a, on_b;
  Vec2 point;     ///< in the WorldFrame
  int direction;  ///< see crossingDirection()
};

/// Where `edge` is no farther than `error` from `other`, which it meets, but for rounding.
Span spanNear(const WorldFrame::Ends& edge, const WorldFrame::Ends& other, double error);

/// All of them: exactly those that share a point.
std::vector<EdgeCrossing> findCrossings(const PosedPair& pair, const WorldFrame& frame);

/// The next edge of a ring, all around, and the one before; positions in the path.
std::size_t edgeAfter(const PolygonData& polygon, std::size_t edge);
std::size_t edgeBefore(const PolygonData& polygon, std::size_t edge);

/// A point of a component's boundary and the edges that it is on (positions; -1: none): a crossing is on one of each, a
/// vertex on two of its polygon.
struct BoundaryPoint {
  Vec2 at;
  std::ptrdiff_t a, a_before, b, b_before;
};

/// A connected part of the overlap.
struct OverlapComponent {
  std::vector<BoundaryPoint> points;   ///< crossings, and vertices inside the other region
  std::vector<std::size_t> crossings;  ///< indices; empty in a containment
  bool inner = false;                  ///< it has an inside, but for rounding: they do more than touch
  Vec2 facing = Vec2::Zero();          ///< where they touch along edges: the sum of these, turned to point from a to b
};

/// The components of the overlap; none exactly if the regions are apart. What is nearer than the frame's error counts
/// as connected.
std::vector<OverlapComponent> findComponents(const PosedPair& pair, const WorldFrame& frame,
                                             const std::vector<EdgeCrossing>& crossings);

}  // namespace tricover::detail
