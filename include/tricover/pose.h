// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "tricover/export.h"

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "tricover's answers are proven for IEEE arithmetic: don't compile or link with -ffast-math or -ffinite-math-only"
#endif

namespace tricover {

/// A point or vector of the plane.
using Vec2 = Eigen::Vector2d;

/// A rigid map p -> R p + t from a polygon's own frame to the world. It is exactly the one that the stored doubles
/// define: R may miss orthonormality by rounding and is never re-normalised. R may mirror (det R < 0).
/// \snippet pose.cpp pose
using Pose = Eigen::Isometry2d;

/// How far an entry of R^T R may be from the identity's. Rounding to float (1e-7) passes; a scale or a shear doesn't.
constexpr double kRigidTolerance = 1e-6;

/// Checks a pose as every query does. Throws std::invalid_argument, naming `name` and the field, unless it is finite
/// and rigid within kRigidTolerance.
///
/// \snippet pose.cpp pose
TRICOVER_EXPORT void checkPose(const Pose& pose, const char* name = "pose");

}  // namespace tricover
