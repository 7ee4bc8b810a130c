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

  /// An upper bound of |singular value - 1|: the eigenvalues of M^T M are within max(|c0.c0 - 1|, |c1.c1 - 1|) +
  /// |c0.c1| of 1, and |s - 1| <= |s^2 - 1|. 16 kUnitRoundoff cover the rounding here.
  double defect() const { return std::max(norms[0], norms[1]) + dot + 16 * kUnitRoundoff; }

  Double2 norms;  ///< |c0.c0 - 1|, |c1.c1 - 1|
  double dot;     ///< |c0.c1|
};

/// The defect of every pose that checkPose lets pass is below this.
constexpr double kLargestDefect = 2.1 * kRigidTolerance;

/// checkPose for hot paths: one comparison for most poses. Written so that NaN and infinity fail.
inline void requireRigid(const Pose& pose, const char* name) {
  const double* m = pose.data();  // columns of three
  const Gram gram(load2(m), load2(m + 3));
  const Double2 shift = load2(m + 6), finite = shift - shift;
  if (!(gram.norms[0] + gram.norms[1] + gram.dot + (finite[0] + finite[1]) <= kRigidTolerance)) checkPose(pose, name);
}

}  // namespace tricover::detail
