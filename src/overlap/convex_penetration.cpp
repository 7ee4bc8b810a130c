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

// A product of a normal n, known to within U, with a difference d of corners, in plain doubles. M is at least their
// coordinates, so those of d are below 2 M; in units of U M |n|_1:
//   corners, rounded to their high parts, 1 each; their difference 2      4
//   n                                                                     2
//   two products, their sum                                               2 * 2
// Divided by the length of n that is at most 10 sqrt2 U M. The length (of n 1, of hypot 2) and the quotient add 4 U of
// the depth, which is at most 2 sqrt2 M: twice the bound below.
constexpr double kPlainError = 16 * kUnitRoundoff;
static_assert(kPlainError >= (1 + 1e-5) * errorOf(4 + 2 + 2 * 2));
static_assert(2 * kPlainError >= (1 + 1e-5) * kRoot2 * errorOf(10 + 4 * 2));

double plainDot(const DoubleDouble2& normal, const DoubleDouble2& p, const DoubleDouble2& q) {
  return normal.x.high * (p.x.high - q.x.high) + normal.y.high * (p.y.high - q.y.high);
}

/// The least gap over the edges of one of them, both counter-clockwise, no coordinate larger than `largest`. While the
/// normal turns, the other's farthest corner goes around at most once. Double doubles only where plain ones are unsure.
Gap leastGap(const Corners& of, const Corners& other, double largest) {
  Gap least;
  const std::size_t n = of.size(), m = other.size();
  if (n < 2) return least;
  const double error = kPlainError * largest;
  const auto normalOf = [&](std::size_t k) {
    const DoubleDouble2 edge = of[k + 1 < n ? k + 1 : 0] - of[k];
    return DoubleDouble2{edge.y, -edge.x};
  };
  const auto isFarther = [&](std::size_t j, std::size_t i, const DoubleDouble2& normal) {
    const double plain = plainDot(normal, other[j], other[i]);
    if (std::abs(plain) > error * (std::abs(normal.x.high) + std::abs(normal.y.high))) return plain < 0;
    return dot(normal, other[j] - other[i]).high < 0;
  };
  std::vector<std::size_t> farthest(n);
  std::vector<double> depths(n);
  double enough = std::numeric_limits<double>::infinity();  // the least depth isn't more
  for (std::size_t k = 0, at = 0; k < n; ++k) {
    const DoubleDouble2 normal = normalOf(k);
    // A segment's normals are opposite: on the way from one to the other a step may be no descent.
    if (k == 0 || n == 2)
      for (std::size_t j = 0; j < m; ++j)
        if (isFarther(j, at, normal)) at = j;
    for (std::size_t steps = 0; steps < m; ++steps) {
      const std::size_t next = at + 1 < m ? at + 1 : 0;
      if (!isFarther(next, at, normal)) break;
      at = next;
    }
    farthest[k] = at;
    depths[k] = plainDot(normal, of[k], other[at]) / std::hypot(normal.x.high, normal.y.high);
    enough = std::min(enough, depths[k] + 2 * error);
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (depths[k] - 2 * error > enough) continue;
    const DoubleDouble2 normal = normalOf(k);
    const double length = std::hypot(normal.x.high, normal.y.high);
    const double depth = std::max(0.0, dot(normal, of[k] - other[farthest[k]]).high / length);
    if (!(depth < least.depth && length > 0)) continue;
    // Of short edges among huge ones the normal may be one of the smallest doubles, and its length hardly known.
    const double larger = std::max(std::abs(normal.x.high), std::abs(normal.y.high));
    least = {depth, Vec2(normal.x.high / larger, normal.y.high / larger).normalized(), k, farthest[k]};
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
  double most = 0;
  for (const Corners* corners : {&corners_a, &corners_b})
    for (const DoubleDouble2& p : *corners) most = std::max({most, std::abs(p.x.high), std::abs(p.y.high)});
  const Gap of_a = leastGap(corners_a, corners_b, most), of_b = leastGap(corners_b, corners_a, most);
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
