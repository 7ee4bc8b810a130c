// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "contact/world_frame.h"

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

/// Where two edges are nearest to each other, rounded, of those that don't cross.
struct NearestPlaces {
  Vec2 on_a, on_b;
};
NearestPlaces nearestPlaces(const WorldFrame::Ends& edge_a, const WorldFrame::Ends& edge_b);

/// All pairs of edges that share a point, exactly.
std::vector<EdgeCrossing> findCrossings(const PosedPair& pair, const WorldFrame& frame);

}  // namespace tricover::detail
