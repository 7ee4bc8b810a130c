// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "tricover/export.h"
#include "tricover/pose.h"

namespace tricover {

/// One end of a cubic Hermite spline: where a body is, and how it moves there. The whole spline takes one unit of time.
struct SplineEnd {
  Vec2 position;            ///< The pivot, in the world.
  double angle;             ///< The body's heading: radians, counter-clockwise, any number of turns.
  Vec2 velocity;            ///< The pivot's velocity, in the world.
  double angular_velocity;  ///< Radians per unit of time.
};

/// A planar rigid motion from time 0 to time 1. The polygon rotates about a pivot of its own, and the pivot moves.
///
/// At time t the pivot has moved by t shift + t^2 shift_2 + t^3 shift_3, and the polygon has rotated by t angle + t^2
/// angle_2 + t^3 angle_3. With `shift` and `angle` alone, both velocities are constant: with angle 0 that is a
/// translation, with shift 0 a rotation about a fixed point (the plane's screw motion), and with both an interpolation
/// between two poses. With the other terms it is a cubic spline in x, y and heading.
///
/// \snippet motion.cpp motion
struct TRICOVER_EXPORT Motion {
  Pose start = Pose::Identity();  ///< The pose at time 0, from the polygon's frame to the world.
  Vec2 shift = Vec2::Zero();      ///< How far the pivot moves from time 0 to 1, in the world; its velocity at time 0.
  double angle = 0;               ///< How far the polygon rotates: radians, counter-clockwise, any number of turns.
  Vec2 pivot = Vec2::Zero();      ///< The pivot, in the polygon's frame.
  Vec2 shift_2 = Vec2::Zero();    ///< The factor of t^2 in the pivot's translation, in the world.
  Vec2 shift_3 = Vec2::Zero();    ///< The factor of t^3 in the pivot's translation, in the world.
  double angle_2 = 0;             ///< The factor of t^2 in the rotation, in radians.
  double angle_3 = 0;             ///< The factor of t^3 in the rotation, in radians.

  /// Returns a motion that stays at the pose.
  static Motion still(const Pose& pose);
  /// Returns a translation without a rotation.
  static Motion translation(const Pose& start, const Vec2& shift);
  /// Returns a rotation about a fixed point of the world, counter-clockwise for a positive angle.
  static Motion arc(const Pose& start, const Vec2& centre, double angle);
  /// Returns a motion from pose to pose: a rotation in (-pi, pi], and the pivot on a straight line. at(1) is `end` up
  /// to rounding, and up to how far the two linear parts differ by more than a rotation.
  /// \throws std::invalid_argument for a pose that checkPose() refuses, for two poses of which only one mirrors, and
  /// for a pivot that is not finite
  static Motion between(const Pose& start, const Pose& end, const Vec2& pivot = Vec2::Zero());

  /// The cubic Hermite spline from one end to the other. The polygon's frame has the ends' angles, and its pivot their
  /// positions.
  /// \throws std::invalid_argument for a value that is not finite
  static Motion spline(const SplineEnd& begin, const SplineEnd& end, const Vec2& pivot = Vec2::Zero());

  /// One segment of a uniform cubic B-spline, by its four control points and angles, as fcl::SplineMotion keeps them.
  /// At time t the pivot is at ((1 - t)^3 P0 + (3 t^3 - 6 t^2 + 4) P1 + (-3 t^3 + 3 t^2 + 3 t + 1) P2 + t^3 P3) / 6,
  /// and likewise the angle.
  /// \throws std::invalid_argument for a value that is not finite
  static Motion spline(const std::array<Vec2, 4>& positions, const std::array<double, 4>& angles,
                       const Vec2& pivot = Vec2::Zero());

  /// The pose at `time`, rounded. At 0 it is exactly `start`.
  /// \throws std::invalid_argument for a time that is not finite
  Pose at(double time) const;

  /// The same motion from one time to another, which are its 0 and 1: at(0) of it is exactly at(from), and the rest is
  /// right to rounding.
  /// \throws std::invalid_argument for a time that is not finite
  Motion part(double from, double until) const;
};

/// Checks a motion as timeOfImpact() does.
///
/// \throws std::invalid_argument unless all of it is finite and checkPose() accepts its start. The text has `name` and
/// the field.
///
/// \snippet motion.cpp check motion
TRICOVER_EXPORT void checkMotion(const Motion& motion, const char* name = "motion");

}  // namespace tricover
