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

#if defined(__x86_64__) || defined(__aarch64__)
static_assert(alignof(Vec2) == 16,
              "tricover's types hold Eigen's vectors as its library was built, aligned to 16 bytes: build without "
              "EIGEN_MAX_STATIC_ALIGN_BYTES, EIGEN_DONT_ALIGN and EIGEN_DONT_VECTORIZE");
#endif

/// A rigid map p -> R p + t from a polygon's own frame to the world. It is exactly the one that the stored doubles
/// define: R may miss orthonormality by rounding and is never re-normalised. R may mirror (det R < 0).
/// \snippet pose.cpp pose
using Pose = Eigen::Isometry2d;

/// Returns the pose of a body at (x, y) in the world whose frame is rotated by `heading`, in radians,
/// counter-clockwise. A heading within rounding of a quarter turn, as M_PI / 2 is, gives exact zeros and ones, so that
/// a part turned by it touches what it touched. \snippet pose.cpp pose
TRICOVER_EXPORT Pose poseAt(double x, double y, double heading = 0);

/// How far an entry of R^T R may be from the identity's. Products of a thousand equal factors of float, or of a hundred
/// thousand different ones, miss it by 6e-5; a scale or a shear that is meant misses it by more. No answer depends on
/// the limit, for all of them are about the map as it is written.
constexpr double kRigidTolerance = 1e-4;

/// Checks a pose as every query does.
///
/// \throws std::invalid_argument unless it is finite and rigid within kRigidTolerance. The text has `name`, the field,
/// and how far it is off.
///
/// \snippet pose.cpp pose
TRICOVER_EXPORT void checkPose(const Pose& pose, const char* name = "pose");

/// The rigid map nearest to it, to a rounding: R becomes the orthogonal factor of its polar decomposition, so that a
/// scale and a shear are dropped; what mirrors still does, and the translation stays.
///
/// \throws std::invalid_argument for a map that is not finite, or takes the plane to a line or a point, to which no
/// rigid map is nearest. The text has `name`.
///
/// \snippet pose.cpp nearest
TRICOVER_EXPORT Pose nearestRigid(const Pose& pose, const char* name = "pose");

}  // namespace tricover
