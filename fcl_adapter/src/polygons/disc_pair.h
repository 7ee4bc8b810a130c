// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <optional>

#include "shape/heights.h"
#include "shape/planar_pose.h"
#include "tricover_fcl/polygon_shape.h"

namespace tricover_fcl {

/// Two shapes that are discs, as a row gets them: their centres are the poses' translations. Plain doubles tell most of
/// what is asked about them, as exactly as the kernel; it answers the rest, as of any two polygons.
template <typename S>
class DiscPair {
 public:
  DiscPair(const PolygonShape<S>& a, const fcl::Transform3<S>& pose_a, const PolygonShape<S>& b,
           const fcl::Transform3<S>& pose_b)
      : between(at(pose_b, 0) - at(pose_a, 0), at(pose_b, 1) - at(pose_a, 1)),
        square_(between.x() * between.x() + between.y() * between.y()),
        heights_a_(heightsOf(a.options(), pose_a)),
        heights_b_(heightsOf(b.options(), pose_b)),
        is_plain_(square_ > 0x1p-900 && square_ < 0x1p900 && isPlainlyPlanar(pose_a) && isPlainlyPlanar(pose_b) &&
                  share(heights_a_, heights_b_)) {}

  static bool areDiscs(const PolygonShape<S>& a, const PolygonShape<S>& b) { return a.isDisc() && b.isDisc(); }

  /// Whether the centres are within that of each other. The square errs by 4U, of two differences, products and a sum;
  /// that of the reach by U, and times what rounds itself by 2U.
  std::optional<bool> areWithin(double reach) const {
    constexpr double kSquares = 0x1p-50;  // 8U
    if (!(is_plain_ && reach >= 0 && reach < 0x1p450)) return std::nullopt;
    const double square = reach * reach;
    if (square_ > square * (1 + kSquares)) return false;
    if (square_ < square * (1 - kSquares)) return true;
    return std::nullopt;
  }

  /// The distance of the centres, to 3.1U of it, if that is certainly more than `reach`.
  std::optional<double> distanceBeyond(double reach) const {
    const double distance = std::sqrt(square_);
    if (!(is_plain_ && distance * (1 - 0x1p-40) > reach)) return std::nullopt;
    return distance;
  }

  double middleHeight() const { return sharedHeights(heights_a_, heights_b_).middle(); }

  const tricover::Vec2 between;  ///< from a's centre to b's

 private:
  static double at(const fcl::Transform3<S>& pose, int axis) { return static_cast<double>(pose.matrix()(axis, 3)); }

  const double square_;
  const Heights heights_a_, heights_b_;
  const bool is_plain_;
};

}  // namespace tricover_fcl
