// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cassert>
#include <cmath>
#include <cstddef>

#include "hierarchy/placement.h"
#include "numbers/predicates.h"
#include "numbers/rigidity.h"
#include "polygon/polygon_data.h"
#include "tricover/locate.h"

namespace tricover::detail {

/// Error of the mapping p -> M p + t, M = R_a^-1 R_b = d adj(R_a) R_b, t = R_a^-1 (t_b - t_a), in either coordinate.
/// Rows and columns of a pose are unit vectors and d = 1 / det R_a is +-1, but for kUnitRows; the entries of adj(R_a)
/// are those of R_a. In units of U:
///   det    products 1 (of |row| |column|), difference 1                                        2
///   d      det 2, division 1                                                                   3
///   M_ij   products and difference 2 s_ij, d and the last product (3 + 1) |M_ij|               2 s_ij + 4 |M_ij|
///   t_i    shift 1, products 1, difference 1, d 3, product 1                                   7 |t_b - t_a|_1
/// with s_ij the magnitudes of both products, whose squares sum to at most 2 in a row. Applied to a vertex or S, whose
/// coordinates are at most the polygon's extent e, so that its length is at most sqrt2 e:
///   entries of M                               2 sqrt2 sqrt2 e + 4 sqrt2 e
///   two products, their sum, the sum with t    3 sqrt2 e
///   t, the sum with it                         (7 + 1) |t_b - t_a|_1
/// which is below 13.9 e + 8 |t_b - t_a|_1: the power of two above it. kTiny is for underflow. R^-1 is the true
/// inverse, so a pose's defect from orthonormality is no error here; it enters `defect` and `scale_defect`.
///
/// As a matrix, M errs by the spectral norms of 3U M (d), U M (the last product, entry by entry: sqrt2) and of 2U s_ij
/// (at most 2U * 2): see Gram::defect().
constexpr double kMappingError = 16 * kUnitRoundoff;
static_assert(kMappingError >= kUnitRows * errorOf(1) * (2 * kRoot2 * kRoot2 + (4 + 3) * kRoot2));
static_assert(Gram::kMatrixError >= kUnitRows * errorOf(1) * (3 + kRoot2 + 2 * 2));

/// v -> R^-1 v = adj(R) v / det R, for the R of a pose.
struct TurnBack {
  explicit TurnBack(const Pose& pose) {
    const Double2 r0 = load2(pose.data()), r1 = load2(pose.data() + 3);  // columns of three
    const double det = r0[0] * r1[1] - r1[0] * r0[1];
    diagonal = Double2{r1[1], r0[0]};
    off = Double2{r1[0], r0[1]};
    d = 1 / det - Double2{};
    handed = det < 0 ? -1 : 1;
  }
  Double2 operator()(Double2 v) const { return (diagonal * v - off * swapped(v)) * d; }

  Double2 diagonal, off, d;
  int handed;  ///< the sign of det R
};

/// Two polygons under their poses, seen from a's frame. The relative pose is rounded, so it serves filters and bounds
/// only; exact stages use the two poses as given.
struct PosedPair {
  PosedPair(const PolygonData& a_, const Pose& pose_a_, const PolygonData& b_, const Pose& pose_b_)
      : a(a_), b(b_), pose_a(pose_a_), pose_b(pose_b_) {
    const double *ra = pose_a.data(), *rb = pose_b.data();  // columns of three
    const Double2 shift = load2(rb + 6) - load2(ra + 6), apart = absolute(shift);
    const TurnBack to_a(pose_a);
    const Double2 m0 = to_a(load2(rb)), m1 = to_a(load2(rb + 3)), t = to_a(shift);
    store2(&m00, m0);
    store2(&m01, m1);
    store2(&tx, t);
    store2(&center_x, m0 * b.origin.x() + m1 * b.origin.y() + t);
    error = kMappingError * (b.extent + apart[0] + apart[1]) + kTiny;
    defect = Gram(m0, m1).defect();
    scale_defect = Gram(load2(ra), load2(ra + 3)).defect();
    handed = to_a.handed;
    // NaN of poses near the ends of the range is uncertain, no less.
    assert(!(error < kTiny) && !(defect < 0) && scale_defect < kLargestDefect);
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
  double radiusB() const { return roundedUp<2>(b.radius * (1 + defect)); }

  /// A length in a's frame that is at least the world's `length`: 1 / (1 - x) <= 1 + 2 x, with x - x^2 to spare, and
  /// scale_defect is at least 16U, so that is more than the two roundings.
  double reach(double length) const { return length * (1 + 2 * scale_defect); }

  const PolygonData &a, &b;
  const Pose &pose_a, &pose_b;
  double m00, m10, m01, m11, tx, ty;  ///< rounded R_a^-1 R_b, by columns, and R_a^-1 (t_b - t_a)
  double center_x, center_y;          ///< see center()
  double error;                       ///< of each coordinate of a mapped vertex of b, or of b's origin
  double defect;                      ///< |len' / len - 1| for any length len of b's frame taken to a's
  double scale_defect;                ///< the same from a's frame to the world
  int handed;                         ///< sign of det R_a: exact signs are the world's, filters' are those of a's frame
};

/// b in a's units by the relative pose, whose inverse is the true one.
inline UnitPlacement unitsOf(const PosedPair& pair) {
  return {pair.a,
          pair.b,
          load2(&pair.m00),
          load2(&pair.m01),
          (load2(&pair.center_x) - load2(pair.a.origin.data())) * pair.a.inverse_unit,
          1.5 * pair.error,
          0,
          pair.defect,
          pair.scale_defect};
}

/// Whether edge i of a and edge j of b (positions in the paths) share a point. Exact.
bool edgesMeet(const PosedPair& pair, std::size_t i, std::size_t j);

/// Whether they come within `reach` in the world. True is certain up to `reach`, and may be answered up to reach +
/// tolerance only. Exact where tolerance is 0. Strictly: whether they come nearer than a `reach` that isn't 0.
bool edgesWithin(const PosedPair& pair, std::size_t i, std::size_t j, double reach, double tolerance,
                 bool strictly = false);

/// Where the filters prove that two edges cross at a point inside both: 1 if, in the world, b's edge leads from the
/// right of a's to the left, -1 for the other way. Otherwise 0.
int crossingDirection(const PosedPair& pair, std::size_t i, std::size_t j);

/// How far, in a's frame, each point of b may at least be moved before these two edges come apart; 0 where that isn't
/// certain.
double crossingDepth(const PosedPair& pair, std::size_t i, std::size_t j);

/// The paper's Algorithm 1 for b's point `local` against a, under a's fill rule. Exact.
Location locate(const PosedPair& pair, const Vec2& local);

}  // namespace tricover::detail
