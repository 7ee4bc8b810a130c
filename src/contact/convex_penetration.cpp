// SPDX-License-Identifier: BSD-3-Clause
#include "contact/convex_penetration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "numbers/double_double.h"
#include "numbers/predicates.h"

namespace tricover::detail {
namespace {

/// Corners in the world less a's translation, times a power of two that keeps products in range.
class Corners {
 public:
  Corners(const PolygonData& polygon, const Pose& pose, const std::vector<std::size_t>& positions,
          const DoubleDouble2& shift, double scale)
      : polygon_(polygon), pose_(pose), positions_(positions), shift_(shift), scale_(scale) {
    plain_.reserve(positions.size());
    const Eigen::Matrix2d linear = pose.linear();
    const Vec2 by(shift.x.high, shift.y.high);
    for (const std::size_t i : positions) plain_.push_back(linear * (polygon.path[i] * scale) + by);
  }

  std::size_t size() const { return positions_.size(); }
  /// In plain doubles.
  const Vec2& near(std::size_t k) const { return plain_[k]; }
  DoubleDouble2 at(std::size_t k) const {
    const auto& m = pose_.matrix();
    const Vec2 p = polygon_.path[positions_[k]] * scale_;
    const auto row = [&](int r, const DoubleDouble& t) {
      return twoProduct(m(r, 0), p.x()) + twoProduct(m(r, 1), p.y()) + t;
    };
    return {row(0, shift_.x), row(1, shift_.y)};
  }
  /// At least any coordinate and the magnitudes that it is summed up from, but for kLargestDefect.
  double reach() const { return polygon_.extent * scale_ + std::abs(shift_.x.high) + std::abs(shift_.y.high); }

 private:
  const PolygonData& polygon_;
  const Pose& pose_;
  const std::vector<std::size_t>& positions_;
  DoubleDouble2 shift_;
  double scale_;
  std::vector<Vec2> plain_;
};

struct Gap {
  double depth = std::numeric_limits<double>::infinity();
  Vec2 normal = Vec2(1, 0);  ///< outwards from `of`
  std::size_t edge = 0, corner = 0;
};

// The products of a normal n and a difference d of corners in plain doubles. M is at least their reach(), so that in
// either coordinate n and d are below 2 M; in units of U M:
//   corners        products 1, sum 1, the sum with the shift 1, its low part 1    4
//   n, d           two corners, their difference 2                                10 each
//   the area       10 for d, of |n|_1; 10 for n, of |d|_1 <= 4 M                  10 |n|_1 + 40 M
//                  two products, their sum, of at most 2 M |n|_1                  4 |n|_1
// Divided by the length of n, which is at least |n|_1 / sqrt2. That errs by 10 sqrt2 U M and by 2 U of itself, the
// quotient by U: of the depth, which is at most 2 sqrt2 M, these make 41 U M of M / |n| and 9 U M. All of it is at most
// twice the bound below.
constexpr double kNormalError = 16 * kUnitRoundoff, kDifferenceError = 48 * kUnitRoundoff;
static_assert(kNormalError >= (1 + 1e-5) * errorOf(10 + 4) && kDifferenceError >= (1 + 1e-5) * errorOf(40));
static_assert(2 * kNormalError >= (1 + 1e-5) * (kRoot2 * errorOf(14) + errorOf(9)));
static_assert(2 * kDifferenceError >= (1 + 1e-5) * errorOf(40 + 41));

/// The least gap over the edges of one of them, both counter-clockwise, no coordinate larger than `largest`. While the
/// normal turns, the other's farthest corner goes around at most once. Double doubles only where plain ones are unsure.
Gap leastGap(const Corners& of, const Corners& other, double largest) {
  Gap least;
  const std::size_t n = of.size(), m = other.size();
  if (n < 2) return least;
  const auto after = [n](std::size_t k) { return k + 1 < n ? k + 1 : 0; };
  const auto normalOf = [&](std::size_t k) {
    const DoubleDouble2 edge = of.at(after(k)) - of.at(k);
    return DoubleDouble2{edge.y, -edge.x};
  };
  std::vector<std::size_t> farthest(n);
  std::vector<double> depths(n), errors(n);
  double enough = std::numeric_limits<double>::infinity();  // the least depth isn't more
  for (std::size_t k = 0, at = 0; k < n; ++k) {
    const Vec2 edge = of.near(after(k)) - of.near(k), normal(edge.y(), -edge.x());
    const double error = largest * (kNormalError * normal.lpNorm<1>() + kDifferenceError * largest);
    const auto isFarther = [&](std::size_t j, std::size_t i) {
      const double plain = normal.dot(other.near(j) - other.near(i));
      if (std::abs(plain) > error) return plain < 0;
      return dot(normalOf(k), other.at(j) - other.at(i)).high < 0;
    };
    // A segment's normals are opposite: on the way from one to the other a step may be no descent.
    if (k == 0 || n == 2)
      for (std::size_t j = 0; j < m; ++j)
        if (j != at && isFarther(j, at)) at = j;
    for (std::size_t steps = 0; steps < m; ++steps) {
      const std::size_t next = at + 1 < m ? at + 1 : 0;
      if (!isFarther(next, at)) break;
      at = next;
    }
    farthest[k] = at;
    const double length = normal.norm();
    // Where squares lose digits, or the length is hardly known, nothing is.
    const bool known = length > 0x1p-400 && length > 64 * kUnitRoundoff * largest;
    depths[k] = known ? normal.dot(of.near(k) - other.near(at)) / length : 0;
    errors[k] = known ? 2 * error / length : std::numeric_limits<double>::infinity();
    enough = std::min(enough, depths[k] + errors[k]);
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (depths[k] - errors[k] > enough) continue;
    const DoubleDouble2 normal = normalOf(k);
    const double length = std::hypot(normal.x.high, normal.y.high);
    const double depth = std::max(0.0, dot(normal, of.at(k) - other.at(farthest[k])).high / length);
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
  const Corners corners_a(a, pose_a, at_a, {}, scale), corners_b(b, pose_b, at_b, shift, scale);
  const double most = std::max(corners_a.reach(), corners_b.reach());
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
