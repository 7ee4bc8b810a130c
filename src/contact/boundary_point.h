// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "hierarchy/inclusion.h"
#include "hierarchy/simd.h"
#include "numbers/rigidity.h"
#include "pair/world_frame.h"
#include "polygon/edge_walk.h"

namespace tricover::detail {

// Sides of a pair are 0 for a and 1 for b.
inline const PolygonData& polygonOf(const PosedPair& pair, int side) { return side == 0 ? pair.a : pair.b; }
inline const Pose& poseOf(const PosedPair& pair, int side) { return side == 0 ? pair.pose_a : pair.pose_b; }

/// A point of an overlap's boundary, in the WorldFrame, and the edges by side that it is on (or kNoEdge): a
/// crossing is on one of each, a vertex on two of its polygon.
struct BoundaryPoint {
  Vec2 at;
  EdgePosition edge[2] = {kNoEdge, kNoEdge}, before[2] = {kNoEdge, kNoEdge};
};

/// A vertex, and the edges there beyond repetitions of it.
inline BoundaryPoint vertexPoint(const PolygonData& polygon, int side, EdgePosition v, const Vec2& at) {
  const EdgesAt edges = edgesAt(polygon, v);
  BoundaryPoint point{at};
  point.edge[side] = edges.after;
  point.before[side] = edges.before;
  return point;
}

/// A winding number or a change of one, where that is known.
struct Winding {
  /// On the way past a place where it changes.
  void pass(const Winding& change) {
    known = known && change.known;
    number += change.number;
  }

  bool known = false;
  int number = 0;
};

/// Where a vertex of b is in a's region, and how that winds around it in the world. Exact.
inline Inclusion includeVertexOfB(const PosedPair& pair, EdgePosition v) {
  const Inclusion found = includeInPolygon(pair.a, seenFromA(pair, pair.b.path[v]));
  return {found.location, isMirrored(pair.pose_a) ? -found.winding : found.winding};
}

/// Whether a rounded point of the WorldFrame is in one side's region (0: a's, 1: b's).
inline bool holds(const PosedPair& pair, const WorldFrame& frame, int side, const Vec2& p) {
  const Vec2 local = side == 0 ? frame.toA(p) : frame.toB(p);
  return locateInPolygon(polygonOf(pair, side), IncludedPoint::ofFrame(local)) != Location::Outside;
}

/// Calls visit(edge), a position, for every edge of one polygon (side 0: a's, 1: b's) that the way from `from` along
/// the unit vector `direction` may come within a few of the frame's errors of. visit returns how long the way still is;
/// all are in the WorldFrame.
template <typename Visit>
void forEachEdgeOnRay(const PosedPair& pair, const WorldFrame& frame, int side, const Vec2& from, const Vec2& direction,
                      double length, Visit visit) {
  const PolygonData& polygon = polygonOf(pair, side);
  const Vec2 at = polygon.inUnits(side == 0 ? frame.toA(from) : frame.toB(from));
  const Eigen::Matrix2d linear = poseOf(pair, side).linear();
  const Vec2 along = (linear.inverse() * direction).normalized();
  const double scale = frame.unit() * polygon.inverse_unit;
  const double error = 4 * frame.error() * scale + 0x1p-40 * (at.norm() + 4);
  const auto inUnits = [scale, error](double world) { return world * scale * (1 + 0x1p-10) + error; };
  Ray ray{at.x(), at.y(), along.x(), along.y(), error, inUnits(length)};
  forEachEdgeOn(polygon, &ray, [&](EdgePosition edge) {
    ray.length = inUnits(visit(edge));
    return true;
  });
}

}  // namespace tricover::detail
