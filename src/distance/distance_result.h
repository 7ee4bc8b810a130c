// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "convex/posed_vertices.h"
#include "distance/distance_query.h"
#include "distance/edge_distance.h"
#include "polygon/polygon_data.h"

namespace tricover::detail {

/// A point in the world, rounded as a posed vertex is.
inline Vec2 posed(const Pose& pose, const Vec2& p) {
  const double* m = pose.data();  // columns of three
  Vec2 point;
  store2(point.data(), (load2(m) * p.x() + load2(m + 3) * p.y()) + load2(m + 6));
  return point;
}

/// A point of an edge in the world, rounded as a posed vertex is; of what is neither large nor far from the origin.
inline Vec2 plainPoint(const PolygonData& polygon, const Pose& pose, EdgePosition edge, double along) {
  const Double2 v = load2(polygon.path[edge].data()), w = load2(polygon.path[edge + 1].data());
  Vec2 point;
  store2(point.data(), along == 0 ? v : along == 1 ? w : v + along * (w - v));
  return posed(pose, point);
}

/// What is left of a distance that EdgeDistances::at() returned. Where rounding hides whether anything is, collide()
/// tells.
double beyondMargin(const PosedVertices& pair, double distance, double margin);

inline DistanceResult inCallersOrder(const PosedVertices& pair, double distance, const Vec2& point_a,
                                     const Vec2& point_b, EdgeIndex edge_a, EdgeIndex edge_b) {
  if (pair.is_swapped) return {distance, point_b, point_a, edge_b, edge_a};
  return {distance, point_a, point_b, edge_a, edge_b};
}

/// Of what is beyond the limit.
DistanceResult farResult();

/// distance(), without a cache and of checked options.
DistanceResult distanceInOrder(const PosedVertices& pair, const DistanceQuery& options);

/// Of edges i and j, where they are nearest; or their common point, if they meet.
DistanceResult resultOf(const PosedVertices& pair, const EdgeDistance& nearest, bool meets, EdgePosition i,
                        EdgePosition j, const DistanceQuery& options);

/// The same of what is unscaled (PosedVertices::isUnscaled()): neither large nor far from the origin.
inline DistanceResult plainResultOf(const PosedVertices& pair, const EdgeDistance& nearest, bool meets, EdgePosition i,
                                    EdgePosition j, const DistanceQuery& options) {
  const bool is_within = options.margin > 0 && !(EdgeDistances::below(nearest.distance) > options.margin);
  const double distance = nearest.distance - options.margin;
  if (is_within || !(distance <= options.limit)) return resultOf(pair, nearest, meets, i, j, options);
  const Vec2 point_a = plainPoint(pair.a, pair.pose_a, i, nearest.along_a);
  const Vec2 point_b = meets ? point_a : plainPoint(pair.b, pair.pose_b, j, nearest.along_b);
  return inCallersOrder(pair, distance, point_a, point_b, pair.a.edgeName(i), pair.b.edgeName(j));
}

/// Where a ring lies inside the other region: given by an edge of it, the other one is kNoEdge.
DistanceResult containedResult(const PosedVertices& pair, EdgePosition edge_a, EdgePosition edge_b);

}  // namespace tricover::detail
