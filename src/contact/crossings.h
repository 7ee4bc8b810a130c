// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "contact/boundary_point.h"
#include "overlay/edge_sides.h"
#include "overlay/interiors.h"
#include "pair/world_frame.h"
#include "polygon/edge_walk.h"

namespace tricover::detail {

/// Part of an edge, from 0 at its start to 1 at its end.
struct Span {
  double low, high;
  double middle() const { return 0.5 * low + 0.5 * high; }
};

/// Two edges by side that share a point, and where, but for rounding: more than a point where
/// they are collinear.
struct EdgeCrossing {
  EdgePosition edge[2];
  Span on[2];
  Vec2 point;     ///< in the WorldFrame
  int direction;  ///< see crossingDirection()
};

/// Where `edge` is no farther than `error` from `other`, which it meets, but for rounding.
Span spanNear(const WorldFrame::Ends& edge, const WorldFrame::Ends& other, double error);

/// All pairs of edges that share a point, exactly.
std::vector<EdgeCrossing> findCrossings(const PosedPair& pair, const WorldFrame& frame);

/// Where the outline of the overlap of the interiors is: see CrossingOptions::touching and Touching. Each edge is
/// looked at once.
class InnerCrossings {
 public:
  /// crossings: all of the pair's.
  InnerCrossings(const PosedPair& pair, const std::vector<EdgeCrossing>& crossings)
      : pair_(pair), sides_(PosedRegions({pair})) {
    for (const EdgeCrossing& c : crossings) {
      met_[EdgeSides::A][c.edge[0]].push_back(c.edge[1]);
      met_[EdgeSides::B][c.edge[1]].push_back(c.edge[0]);
    }
  }

  /// Whether it is at this crossing.
  bool has(const EdgeCrossing& c) {
    return crossAlone(pair_, c.edge[0], c.edge[1]) ||
           sides_.of(EdgeSides::A, c.edge[0]).hasAnyAt(&EdgeSides::Piece::bordersBoth, c.edge[1]) ||
           sides_.of(EdgeSides::B, c.edge[1]).hasAnyAt(&EdgeSides::Piece::bordersBoth, c.edge[0]);
  }
  /// Whether it is, or a point of either region in the interior of the other one.
  bool meetAt(const EdgeCrossing& c) {
    return has(c) || isInOtherAt(EdgeSides::A, c.edge[0], c.edge[1]) || isInOtherAt(EdgeSides::B, c.edge[1], c.edge[0]);
  }
  /// The same of a vertex inside the other region, and along its edges as far as they lead without meeting the other
  /// polygon's edges.
  bool meetBeside(const BoundaryPoint& vertex) {
    return (vertex.edge[1] == kNoEdge && meetBeside(EdgeSides::A, vertex.edge[0], vertex.before[0])) ||
           (vertex.edge[0] == kNoEdge && meetBeside(EdgeSides::B, vertex.edge[1], vertex.before[1]));
  }

 private:
  bool isInOtherAt(EdgeSides::Operand operand, EdgePosition edge, EdgePosition at) {
    if (const auto point = pointInOther(operand, edge)) return *point;
    return sides_.of(operand, edge).hasAnyAt(&EdgeSides::Piece::isInOther, at);
  }
  bool meetBeside(EdgeSides::Operand operand, EdgePosition edge, EdgePosition last) {
    if (const auto point = pointInOther(operand, edge)) return *point;
    const auto isAlong = [&](EdgePosition e, int side) {
      const EdgeSides& sides = sides_.of(operand, e);
      return sides.hasAnyUntil(&EdgeSides::Piece::bordersBoth, met_[operand][e], side) ||
             sides.hasAnyUntil(&EdgeSides::Piece::isInOther, met_[operand][e], side);
    };
    return isAlong(edge, 1) || isAlong(last, -1);
  }
  /// Whether a ring that is a point is in the interior of the other region; nothing for other rings.
  std::optional<bool> pointInOther(EdgeSides::Operand operand, EdgePosition edge) {
    if (!beginsPoint(operand == EdgeSides::A ? pair_.a : pair_.b, edge)) return {};
    return isInInterior(pair_, operand, edge, sides_);
  }

  const PosedPair& pair_;
  std::map<EdgePosition, std::vector<EdgePosition>> met_[2];  ///< by edge: the other polygon's edges that it meets
  KnownSides sides_;
};

}  // namespace tricover::detail
