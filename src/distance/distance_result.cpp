// SPDX-License-Identifier: BSD-3-Clause
#include "distance/distance_result.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "distance/distance_search.h"
#include "numbers/double_double.h"
#include "pair/collide_by_hierarchy.h"

namespace tricover::detail {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

/// Rounded as a posed vertex is. What could overflow on the way is made smaller first.
Vec2 worldPoint(const PolygonData& polygon, const Pose& pose, EdgePosition edge, double along) {
  const Double2 shift = absolute(load2(pose.data() + 6));
  if (polygon.extent < 0x1p1000 && shift[0] + shift[1] < 0x1p1000) return plainPoint(polygon, pose, edge, along);
  constexpr double kScale = 0x1p-4;
  Pose smaller = pose;
  smaller.translation() *= kScale;
  const Vec2 v = polygon.path[edge] * kScale, w = polygon.path[edge + 1] * kScale;
  return posed(smaller, along == 0 ? v : along == 1 ? w : Vec2(v + along * (w - v))) / kScale;
}

bool areWithin(const PosedVertices& pair, double margin) {
  return collideByHierarchy(pair, {margin}, 0, Wanted::Answer).collides;
}

/// What is left is above the limit, but what was found may be too large by rounding: whether the truth is within the
/// limit and the margin together, their sum rounded down.
bool isWithinLimit(const PosedVertices& pair, double found, const DistanceQuery& options) {
  if (!(found <= DistanceSearch::mostWithin(options)) || options.limit == 0) return false;
  const DoubleDouble sum = twoSum(std::min(options.limit, kLargest), options.margin);
  return areWithin(pair, std::min(sum.low < 0 ? std::nextafter(sum.high, 0) : sum.high, kLargest));
}

}  // namespace

double beyondMargin(const PosedVertices& pair, double distance, double margin) {
  if (margin == 0) return distance;
  const double finite = std::min(distance, kLargest);
  if (EdgeDistances::below(finite) > margin) return distance - margin;
  const bool within = EdgeDistances::above(finite) <= margin || areWithin(pair, margin);
  return within ? 0 : std::max(distance - margin, std::numeric_limits<double>::denorm_min());
}

DistanceResult farResult() {
  const Vec2 none = Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
  return {std::numeric_limits<double>::infinity(), none, none, -1, -1};
}

DistanceResult resultOf(const PosedVertices& pair, const EdgeDistance& nearest, bool meets, EdgePosition i,
                        EdgePosition j, const DistanceQuery& options) {
  const double distance = beyondMargin(pair, nearest.distance, options.margin);
  if (!(distance <= options.limit) && !isWithinLimit(pair, nearest.distance, options)) return farResult();
  const Vec2 point_a = worldPoint(pair.a, pair.pose_a, i, nearest.along_a);
  const Vec2 point_b = meets ? point_a : worldPoint(pair.b, pair.pose_b, j, nearest.along_b);
  return inCallersOrder(pair, std::min(distance, options.limit), point_a, point_b, pair.a.edgeName(i),
                        pair.b.edgeName(j));
}

DistanceResult containedResult(const PosedVertices& pair, EdgePosition edge_a, EdgePosition edge_b) {
  const Vec2 point =
      edge_a != kNoEdge ? worldPoint(pair.a, pair.pose_a, edge_a, 0) : worldPoint(pair.b, pair.pose_b, edge_b, 0);
  return inCallersOrder(pair, 0, point, point, pair.a.edgeName(edge_a), pair.b.edgeName(edge_b));
}

}  // namespace tricover::detail
