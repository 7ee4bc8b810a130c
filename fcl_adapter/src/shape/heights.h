// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers/double_double.h"
#include "tricover_fcl/polygon_shape.h"

namespace tricover_fcl {

/// How far the box around a complement reaches, which has no end: FCL's trees square and add widths.
template <typename S>
constexpr S kEverywhere = S(sizeof(S) == sizeof(float) ? 0x1p61 : 0x1p509);

/// The heights between which a shape reaches, in a frame. A flat polygon has {0, 0} in its own, one at all heights
/// {-infinity, infinity}.
struct Slab {
  double low, high;

  bool isAll() const { return std::isinf(low) && std::isinf(high); }
  bool isNone() const { return low == std::numeric_limits<double>::infinity(); }
  /// The end that is finite where the other one isn't; 0 for all heights.
  double middle() const {
    const double middle = low / 2 + high / 2;
    return std::isfinite(middle) ? middle : !std::isinf(high) ? high : !std::isinf(low) ? low : 0;
  }
  /// Both are there: at most a rounding apart.
  Slab sharedWith(const Slab& other) const { return {std::max(low, other.low), std::min(high, other.high)}; }
};

/// The heights of nothing: other heights united with these stay as they are.
constexpr Slab kNoHeights{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

inline Slab united(const Slab& a, const Slab& b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

inline Slab grown(const Slab& slab, double by) { return {slab.low - by, slab.high + by}; }

/// A height of a pose plus one of its shape: the exact sum of two doubles.
struct Height {
  double of_pose, of_shape;

  double rounded() const { return of_pose + of_shape; }
  /// What rounding left, exactly, unless rounded() is infinite.
  double rest() const { return tricover::detail::twoSum(of_pose, of_shape).low; }
  Height halved() const { return {of_pose / 2, of_shape / 2}; }  // exact where rounded() is infinite
};

/// Exact. Rounding is monotonic, so sums that round apart are apart; where they round alike, the rests decide.
inline bool isBelow(const Height& x, const Height& y) {
  if (x.rounded() != y.rounded()) return x.rounded() < y.rounded();
  if (std::isinf(x.rounded())) return isBelow(x.halved(), y.halved());
  return x.rest() < y.rest();
}

/// How far x is below y, to three roundings of itself; 0 if and only if it isn't below.
inline double gap(const Height& x, const Height& y) {
  if (!isBelow(x, y)) return 0;
  if (std::isinf(x.rounded()) || std::isinf(y.rounded())) return 2 * gap(x.halved(), y.halved());
  return (y.rounded() - x.rounded()) + (y.rest() - x.rest());
}

/// Where a posed shape lies along the z of a pair's frame.
struct Heights {
  double of_pose;
  Slab of_shape;

  Height low() const { return {of_pose, of_shape.low}; }
  Height high() const { return {of_pose, of_shape.high}; }
};

/// A polygon's under a pose that keeps the plane.
template <typename S>
Heights heightsOf(const PolygonOptions& shape, const fcl::Transform3<S>& pose) {
  const auto& m = pose.matrix();
  const bool upside_down = m(2, 2) < 0;
  return {static_cast<double>(m(2, 3)),
          {upside_down ? -shape.z_high : shape.z_low, upside_down ? -shape.z_low : shape.z_high}};
}

/// How far apart they are: 0 if and only if they share one, exactly.
inline double gap(const Heights& a, const Heights& b) {
  if (a.of_pose == b.of_pose)
    return std::max({b.of_shape.low - a.of_shape.high, a.of_shape.low - b.of_shape.high, 0.0});
  return std::max(gap(a.high(), b.low()), gap(b.high(), a.low()));
}

/// What heights that meet share, rounded; if that is all of them, those of the poses.
inline Slab sharedHeights(const Heights& a, const Heights& b) {
  const Slab shared = Slab{a.low().rounded(), a.high().rounded()}.sharedWith({b.low().rounded(), b.high().rounded()});
  return shared.isAll() ? Slab{std::min(a.of_pose, b.of_pose), std::max(a.of_pose, b.of_pose)} : shared;
}

}  // namespace tricover_fcl
