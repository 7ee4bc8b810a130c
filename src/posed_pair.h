// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "polygon_data.h"
#include "predicates.h"
#include "tricover/locate.h"

namespace tricover::detail {

/// Two polygons under their poses, seen from a's frame. The relative pose is rounded, so it serves filters and bounds
/// only; exact stages use the two poses as given.
struct PosedPair {
  PosedPair(const PolygonData& a_, const Pose& pose_a_, const PolygonData& b_, const Pose& pose_b_);

  /// b's point in a's frame, right to within `error`.
  ApproxPoint fromB(const Vec2& p) const {
    return {m00 * p.x() + m01 * p.y() + tx, m10 * p.x() + m11 * p.y() + ty, error};
  }
  static ApproxPoint fromA(const Vec2& p) { return {p.x(), p.y(), 0}; }

  /// Lower bound of the gap between the bounding discs, in a's frame; negative or NaN where they may meet.
  double discGap() const {
    return normBelow(center_x - a.origin.x(), center_y - a.origin.y()) - (a.radius + radius_b) * (1 + 8 * kUlp) - slack;
  }

  /// A length in a's frame that is at least the world's `length`.
  double reach(double length) const { return length * (1 + 2 * scale_defect); }

  const PolygonData &a, &b;
  const Pose &pose_a, &pose_b;
  double m00, m01, m10, m11, tx, ty;  ///< rounded R_a^-1 R_b and R_a^-1 (t_b - t_a)
  double error;                       ///< of each coordinate of a mapped vertex of b, or of b's origin
  double center_x, center_y;          ///< b's origin in a's frame
  double radius_b;                    ///< b's radius in a's frame
  double defect;                      ///< |len' / len - 1| for any length len of b's frame taken to a's
  double scale_defect;                ///< the same from a's frame to the world
  double slack;                       ///< what a gap computed from boxes or discs in a's frame may be too large by
  int handed;                         ///< sign of det R_a: exact signs are the world's, filters' are those of a's frame
};

/// Whether edge i of a and edge j of b (positions in the paths) share a point. Exact.
bool edgesMeet(const PosedPair& pair, std::size_t i, std::size_t j);

/// Whether they come within `reach` in the world. True is certain up to `reach`, and may be answered up to reach +
/// tolerance only. Exact where tolerance is 0.
bool edgesWithin(const PosedPair& pair, std::size_t i, std::size_t j, double reach, double tolerance);

/// The paper's Algorithm 1 for b's point `local` against a, under a's fill rule. Exact.
Location locate(const PosedPair& pair, const Vec2& local);

}  // namespace tricover::detail
