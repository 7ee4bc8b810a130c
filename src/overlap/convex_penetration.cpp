// SPDX-License-Identifier: BSD-3-Clause
#include "overlap/convex_penetration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "numbers/double_double.h"
#include "numbers/predicates.h"

namespace tricover::detail {
namespace {

/// Corners in the world less a's translation, times a power of two that keeps products in range.
using Corners = std::vector<DoubleDouble2>;

Corners posed(const PolygonData& polygon, const Pose& pose, const std::vector<std::size_t>& positions,
              const DoubleDouble2& shift, double scale) {
  const auto& m = pose.matrix();
  Corners corners;
  corners.reserve(positions.size());
  for (const std::size_t i : positions) {
    const Vec2 p = polygon.path[i] * scale;
    const auto row = [&](int r, const DoubleDouble& t) {
      return twoProduct(m(r, 0), p.x()) + twoProduct(m(r, 1), p.y()) + t;
    };
    corners.push_back({row(0, shift.x), row(1, shift.y)});
  }
  return corners;
}

struct Gap {
  double depth = std::numeric_limits<double>::infinity();
  Vec2 normal = Vec2(1, 0);  ///< outwards from `of`
  std::size_t edge = 0, corner = 0;
};

/// The least gap over the edges of one of them, both counter-clockwise. While the normal turns, the other's farthest
/// corner goes around at most once.
Gap leastGap(const Corners& of, const Corners& other) {
  Gap least;
  const std::size_t n = of.size(), m = other.size();
  if (n < 2) return least;
  std::size_t farthest = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const DoubleDouble2 edge = of[(k + 1) % n] - of[k], normal{edge.y, -edge.x};
    // A segment's normals are opposite: on the way from one to the other a step may be no descent.
    if (k == 0 || n == 2)
      for (std::size_t j = 0; j < m; ++j)
        if (dot(normal, other[j] - other[farthest]).high < 0) farthest = j;
    for (std::size_t steps = 0; steps < m; ++steps) {
      const std::size_t next = (farthest + 1) % m;
      if (!(dot(normal, other[next] - other[farthest]).high < 0)) break;
      farthest = next;
    }
    const double length = std::hypot(normal.x.high, normal.y.high);
    const double depth = std::max(0.0, dot(normal, of[k] - other[farthest]).high / length);
    if (!(depth < least.depth)) continue;
    least = {depth, Vec2(normal.x.high, normal.y.high) / length, k, farthest};
  }
  return least;
}

}  // namespace

SupportGap leastSupportGap(const PolygonData& a, const Pose& pose_a, const ConvexOutline& outline_a,
                           const PolygonData& b, const Pose& pose_b, const ConvexOutline& outline_b) {
  const Vec2 ta = pose_a.translation(), tb = pose_b.translation();
  const double largest = std::max({a.extent, b.extent, ta.lpNorm<Eigen::Infinity>(), tb.lpNorm<Eigen::Infinity>()});
  const int exponent = largest > 0 ? std::clamp(std::ilogb(largest), -1000, 1000) : 0;
  const double scale = std::ldexp(1, -exponent);
  const DoubleDouble2 shift{twoSum(tb.x() * scale, -ta.x() * scale), twoSum(tb.y() * scale, -ta.y() * scale)};
  const auto counterClockwise = [](const Pose& pose, std::vector<std::size_t> corners) {
    if (pose.linear().determinant() < 0) std::reverse(corners.begin(), corners.end());
    return corners;
  };
  const std::vector<std::size_t> at_a = counterClockwise(pose_a, outline_a.corners),
                                 at_b = counterClockwise(pose_b, outline_b.corners);
  const Corners corners_a = posed(a, pose_a, at_a, {}, scale), corners_b = posed(b, pose_b, at_b, shift, scale);
  const Gap of_a = leastGap(corners_a, corners_b), of_b = leastGap(corners_b, corners_a);
  const bool edge_of_a = of_a.depth <= of_b.depth;
  const Gap& least = edge_of_a ? of_a : of_b;
  const bool points = corners_a.size() < 2 && corners_b.size() < 2;  // which any translation parts
  const std::vector<std::size_t>&holder = edge_of_a ? at_a : at_b, &other = edge_of_a ? at_b : at_a;
  return {points ? 0 : least.depth / scale,
          edge_of_a ? least.normal : Vec2(-least.normal),
          edge_of_a,
          holder[least.edge],
          holder[(least.edge + 1) % holder.size()],
          other[least.corner]};
}

}  // namespace tricover::detail
