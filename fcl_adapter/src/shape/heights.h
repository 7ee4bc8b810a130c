// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "numbers/double_double.h"
#include "tricover_fcl/polygon_shape.h"

namespace tricover_fcl {

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

/// Where a posed shape lies along the world's z.
struct Heights {
  Height low, high;
};

inline Heights heightsOf(const PolygonOptions& shape, double z, bool upside_down) {
  if (upside_down) return {{z, -shape.z_high}, {z, -shape.z_low}};
  return {{z, shape.z_low}, {z, shape.z_high}};
}
template <typename S>
Heights heightsOf(const PolygonOptions& shape, const fcl::Transform3<S>& pose) {
  return heightsOf(shape, static_cast<double>(pose.matrix()(2, 3)), pose.matrix()(2, 2) < 0);
}

/// Exact, touching counts.
inline bool share(const Heights& a, const Heights& b) { return !isBelow(a.high, b.low) && !isBelow(b.high, a.low); }

/// How far apart they are: 0 if and only if they share one.
inline double gap(const Heights& a, const Heights& b) { return std::max(gap(a.high, b.low), gap(b.high, a.low)); }

/// What heights that meet share, rounded; if that is all of them, those of the poses.
struct SharedHeights {
  double low, high;
  double middle() const { return low / 2 + high / 2; }
};

inline SharedHeights sharedHeights(const Heights& a, const Heights& b) {
  if (std::isinf(a.high.of_shape) && std::isinf(b.high.of_shape)) {
    return {std::min(a.low.of_pose, b.low.of_pose), std::max(a.low.of_pose, b.low.of_pose)};
  }
  return {std::max(a.low.rounded(), b.low.rounded()), std::min(a.high.rounded(), b.high.rounded())};
}

}  // namespace tricover_fcl
