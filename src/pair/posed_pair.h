// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>

#include "numbers/predicates.h"
#include "numbers/rigidity.h"
#include "polygon/polygon_data.h"
#include "tricover/locate.h"

namespace tricover::detail {

/// Two polygons under their poses, seen from a's frame. The relative pose is rounded, so it serves filters and bounds
/// only; exact stages use the two poses as given.
struct PosedPair {
  // Error of the mapping p -> M p + t. With d = 1 / det R_a, near +-1, the entries of adj(R_a) are those of R_a: exact.
  // M = d adj(R_a) R_b: two products (U each, their magnitudes sum to at most 1 + 2e-6), a sum (U), the reciprocal (U)
  // and its product (U), det's own error (3U): at most 9U an entry. t: the same 7U beside U for the rounded difference
  // t_b - t_a, at most 11U |t_b - t_a|_1. Applying it: two products and two sums, at most 3U (|p|_1 + |t|_1). In all
  // 14U
  // (|p|_1 + |t_b - t_a|_1); 16U and kTiny are used, the latter for underflow. R^-1 is the true inverse, so a pose's
  // defect from orthonormality is no error here; it enters `defect` and `scale_defect`.
  PosedPair(const PolygonData& a_, const Pose& pose_a_, const PolygonData& b_, const Pose& pose_b_)
      : a(a_), b(b_), pose_a(pose_a_), pose_b(pose_b_) {
    const double *ra = pose_a.data(), *rb = pose_b.data();  // columns of three
    const Double2 a0 = load2(ra), a1 = load2(ra + 3), b0 = load2(rb), b1 = load2(rb + 3);
    const Double2 shift = load2(rb + 6) - load2(ra + 6), apart = absolute(shift);
    const double det = a0[0] * a1[1] - a1[0] * a0[1];
    const Double2 diagonal{a1[1], a0[0]}, off{a1[0], a0[1]};
    const Double2 d = 1 / det - Double2{};
    const Double2 m0 = (diagonal * b0 - off * swapped(b0)) * d, m1 = (diagonal * b1 - off * swapped(b1)) * d;
    const Double2 t = (diagonal * shift - off * swapped(shift)) * d;
    store2(&m00, m0);
    store2(&m01, m1);
    store2(&tx, t);
    store2(&center_x, m0 * b.origin.x() + m1 * b.origin.y() + t);
    error = 16 * kUnitRoundoff * (b.extent + apart[0] + apart[1]) + kTiny;
    defect = Gram(m0, m1).defect();
    scale_defect = Gram(a0, a1).defect();
    handed = det < 0 ? -1 : 1;
  }

  // Poses are referred to, so that a temporary one would be gone.
  PosedPair(const PolygonData&, const Pose&&, const PolygonData&, const Pose&) = delete;
  PosedPair(const PolygonData&, const Pose&, const PolygonData&, const Pose&&) = delete;
  PosedPair(const PolygonData&, const Pose&&, const PolygonData&, const Pose&&) = delete;

  /// b's point in a's frame, right to within `error`.
  ApproxPoint fromB(const Vec2& p) const {
    return {m00 * p.x() + m01 * p.y() + tx, m10 * p.x() + m11 * p.y() + ty, error};
  }
  static ApproxPoint fromA(const Vec2& p) { return {p.x(), p.y(), 0}; }

  /// b's origin in a's frame.
  ApproxPoint center() const { return {center_x, center_y, error}; }
  /// b's radius in a's frame.
  double radiusB() const { return b.radius * (1 + defect) * (1 + 4 * kUnitRoundoff); }

  /// A length in a's frame that is at least the world's `length`.
  double reach(double length) const { return length * (1 + 2 * scale_defect); }

  /// What a gap in a's frame between a point or disc of a and b's disc may be too large by: mapping errs by `error` in
  /// both coordinates; sums round by a few U of the lengths involved.
  double slack() const;

  const PolygonData &a, &b;
  const Pose &pose_a, &pose_b;
  double m00, m10, m01, m11, tx, ty;  ///< rounded R_a^-1 R_b, by columns, and R_a^-1 (t_b - t_a)
  double center_x, center_y;          ///< see center()
  double error;                       ///< of each coordinate of a mapped vertex of b, or of b's origin
  double defect;                      ///< |len' / len - 1| for any length len of b's frame taken to a's
  double scale_defect;                ///< the same from a's frame to the world
  int handed;                         ///< sign of det R_a: exact signs are the world's, filters' are those of a's frame
};

/// Whether edge i of a and edge j of b (positions in the paths) share a point. Exact.
bool edgesMeet(const PosedPair& pair, std::size_t i, std::size_t j);

/// Whether they come within `reach` in the world. True is certain up to `reach`, and may be answered up to reach +
/// tolerance only. Exact where tolerance is 0.
bool edgesWithin(const PosedPair& pair, std::size_t i, std::size_t j, double reach, double tolerance);

/// Where the filters prove that two edges cross at a point inside both: 1 if, in the world, b's edge leads from the
/// right of a's to the left, -1 for the other way. Otherwise 0.
int crossingDirection(const PosedPair& pair, std::size_t i, std::size_t j);

/// How far, in a's frame, each point of b may at least be moved before these two edges come apart; 0 where that isn't
/// certain.
double crossingDepth(const PosedPair& pair, std::size_t i, std::size_t j);

/// The paper's Algorithm 1 for b's point `local` against a, under a's fill rule. Exact.
Location locate(const PosedPair& pair, const Vec2& local);

}  // namespace tricover::detail
