// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers/double2.h"
#include "numbers/predicates.h"
#include "tricover/pose.h"

namespace tricover::detail {

/// How far a matrix is from orthonormal, by its columns.
struct Gram {
  Gram(Double2 column0, Double2 column1) {
    const Double2 x{column0[0], column1[0]}, y{column0[1], column1[1]}, product = column0 * column1;
    norms = absolute(x * x + y * y - 1.0);
    dot = std::abs(product[0] + product[1]);
  }

  /// An upper bound of |s - 1| for a singular value s of a matrix that these columns are, but for an error E with |E|
  /// <= 9U in the spectral norm (a pose's own: none; PosedPair's: see there). A singular value s' of the columns has
  /// |s' - 1| = |s'^2 - 1| / (s' + 1), and s'^2, an eigenvalue of the Gram matrix, is within max(norms) + dot of 1:
  ///   0.5 (norms + dot)   with as much of that as it is itself for s' below 1: the whole sum stands for both, and for
  ///                       rounding it
  ///   0.5 (2U + U)        what norms and dot are rounded by
  ///   9U                  |s - s'| <= |E| (Weyl)
  double defect() const { return std::max(norms[0], norms[1]) + dot + kDefectRounding; }

  static constexpr double kMatrixError = 9 * kUnitRoundoff, kDefectRounding = 16 * kUnitRoundoff;
  static_assert(kDefectRounding >= 0.51 * errorOf(2 + 1) + kMatrixError);

  Double2 norms;  ///< |c0.c0 - 1|, |c1.c1 - 1|
  double dot;     ///< |c0.c1|
};

/// The defect of every pose that checkPose lets pass is below this, by 1e-7: what is multiplied by 1 + kLargestDefect
/// or 1 - kLargestDefect may round a million times.
constexpr double kLargestDefect = 2.1 * kRigidTolerance;
static_assert(kLargestDefect >= 2 * kRigidTolerance + Gram::kDefectRounding + 0.9e-7);

/// Bounds of rounding are derived for poses whose rows and columns are unit vectors and whose determinant is +-1. One
/// that checkPose lets pass makes each of them longer by half of kLargestDefect at most, and 1 / det by less than all
/// of it; no bound multiplies more than four. So what was derived holds for all poses if it holds times this.
constexpr double kUnitRows = 1 + 10 * kRigidTolerance;
static_assert(kUnitRows > (1 + kLargestDefect) * (1 + kLargestDefect) * (1 + kLargestDefect) * (1 + kLargestDefect));

/// R^-1 v = adj(R) v / det R, for the R of a pose, by its columns: from the world, less the pose's translation, into
/// its frame.
inline Double2 turnedBack(Double2 column0, Double2 column1, Double2 v) {
  const double det = column0[0] * column1[1] - column1[0] * column0[1];
  return (Double2{column1[1], column0[0]} * v - Double2{column1[0], column0[1]} * swapped(v)) * (1 / det);
}

/// A rounded point. Either coordinate errs by
///   det 2U, d 3U, products 1U, difference 1U, product with d 1U   6U |p|_1
///   the point's own error e                                       at most sqrt2 e
constexpr double kTurnedBackError = 8 * kUnitRoundoff;
static_assert(kTurnedBackError >= kUnitRows * errorOf(6) && 1.5 > kUnitRows * kRoot2);
inline ApproxPoint turnedBack(const Pose& pose, const ApproxPoint& p) {
  const Double2 at = turnedBack(load2(pose.data()), load2(pose.data() + 3), Double2{p.x, p.y});
  return {at[0], at[1], 1.5 * p.error + kTurnedBackError * (std::abs(p.x) + std::abs(p.y)) + kTiny};
}

/// At least Gram::defect() of a pose; above kRigidTolerance, or NaN, for one that isn't finite.
inline double defectOf(const Pose& pose) {
  const double* m = pose.data();  // columns of three
  const Gram gram(load2(m), load2(m + 3));
  const Double2 shift = load2(m + 6), sum = gram.norms + (shift - shift);
  return sum[0] + sum[1] + (gram.dot + Gram::kDefectRounding);
}

/// The same of two poses together: in fewer steps than their sum.
inline double defectOf(const Pose& pose_a, const Pose& pose_b) {
  const double *a = pose_a.data(), *b = pose_b.data();
  const Gram gram_a(load2(a), load2(a + 3)), gram_b(load2(b), load2(b + 3));
  const Double2 shift_a = load2(a + 6), shift_b = load2(b + 6);
  const Double2 sum = gram_a.norms + gram_b.norms + (shift_a - shift_a) + (shift_b - shift_b);
  return sum[0] + sum[1] + (gram_a.dot + gram_b.dot) + 2 * Gram::kDefectRounding;
}

inline bool isMirrored(const Pose& pose) { return pose.linear().determinant() < 0; }

/// Whether checkPose lets a pose pass, by one comparison: most that it does. Written so that NaN fails.
inline bool isPlainlyRigid(const Pose& pose) { return defectOf(pose) <= kRigidTolerance; }

/// checkPose for hot paths. Returns defectOf() the pose.
inline double requireRigid(const Pose& pose, const char* name) {
  const double defect = defectOf(pose);
  if (!(defect <= kRigidTolerance)) checkPose(pose, name);
  return defect;
}

/// The same for two operands' poses at once: most pass together.
inline double requireRigid(const Pose& pose_a, const Pose& pose_b) {
  const double defect = defectOf(pose_a, pose_b);
  if (defect <= kRigidTolerance) return defect;
  requireRigid(pose_a, "pose_a");
  requireRigid(pose_b, "pose_b");
  return defect;
}

}  // namespace tricover::detail
