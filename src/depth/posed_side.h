// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "contact/boundary_point.h"
#include "numbers/rigidity.h"
#include "numbers/segment.h"
#include "pair/world_frame.h"

namespace tricover::detail {

/// One polygon of a pair (side 0 is a, 1 is b) in the pair's WorldFrame, rounded. Edges are positions in its path.
class PosedSide {
 public:
  PosedSide(const PosedPair& pair, const WorldFrame& frame, int side)
      : polygon(polygonOf(pair, side)),
        pair_(pair),
        frame_(frame),
        side_(side),
        defect_(defectOf(poseOf(pair, side))),
        scale_(frame.unit() * polygon.inverse_unit) {}

  Vec2 center() const { return frame_.from(side_, polygon.origin); }
  bool isMirrored() const { return detail::isMirrored(poseOf(pair_, side_)); }
  Vec2 vertex(EdgePosition position) const { return frame_.from(side_, polygon.path[position]); }
  Vec2 foot(EdgePosition edge, const Vec2& p) const { return nearestOnSegment(p, vertex(edge), vertex(edge + 1)); }
  double distance(EdgePosition edge, const Vec2& p) const { return (foot(edge, p) - p).norm(); }
  Location locate(const Vec2& p) const { return locateInPolygon(polygon, IncludedPoint::ofFrame(toLocal(p))); }

  struct Near {
    double distance;
    EdgePosition edge;
    Vec2 point;
  };
  Near nearest(const Vec2& p) const {
    Near best{std::numeric_limits<double>::infinity(), polygon.edgeBegin(0), p};
    const auto offer = [&](EdgePosition edge) {
      const Vec2 at = foot(edge, p);
      if (const double distance = (at - p).norm(); distance < best.distance) best = {distance, edge, at};
      return true;
    };
    std::uint32_t edges[kMostNearest];
    const int count = polygon.path.size() > 16 ? findNearestEdges(hierarchyOf(polygon), placeOf(p), edges) : 0;
    for (int i = 0; i < count; ++i) offer(edges[i]);
    // Lengths of the polygon's frame and of the world are the same but for the defect.
    if (count == 0)
      forEachEdge(polygon, offer);
    else if (defect_ > 64 * kUnitRoundoff)
      forEachNear(p, p, best.distance, offer);
    return best;
  }

  /// Calls visit(edge) until it returns false, for every edge that may be within `reach` of a segment.
  template <typename Visit>
  void forEachNear(const Vec2& p, const Vec2& q, double reach, Visit visit) const {
    const Place from = placeOf(p), to = placeOf(q);
    forEachEdgeNear(polygon, {from.x, from.y}, {to.x, to.y},
                    reach * scale_ * (1 + 2 * defect_) * (1 + 0x1p-40) + 2 * std::max(from.error, to.error), visit);
  }

  const PolygonData& polygon;

 private:
  Vec2 toLocal(const Vec2& p) const { return side_ == 0 ? frame_.toA(p) : frame_.toB(p); }
  Place placeOf(const Vec2& p) const {
    const Vec2 at = polygon.inUnits(toLocal(p));
    return {at.x(), at.y(), 4 * frame_.error() * scale_ + 0x1p-48 * (at.lpNorm<1>() + 4)};
  }

  const PosedPair& pair_;
  const WorldFrame& frame_;
  const int side_;
  const double defect_, scale_;
};

}  // namespace tricover::detail
