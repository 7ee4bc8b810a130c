// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/export.h"
#include "tricover/pose.h"

namespace tricover {

/// A planar rigid motion from time 0 to time 1. The polygon turns at a constant rate about a pivot of its own, and the
/// pivot moves at a constant velocity.
///
/// With angle 0 this is a translation, with shift 0 a rotation about a fixed point (the plane's screw motion), and with
/// both an interpolation between two poses.
///
/// \snippet motion.cpp motion
struct TRICOVER_EXPORT Motion {
  Pose start = Pose::Identity();  ///< The pose at time 0, from the polygon's frame to the world.
  Vec2 shift = Vec2::Zero();      ///< How far the pivot moves from time 0 to 1, in the world.
  double angle = 0;               ///< How far the polygon turns: radians, counter-clockwise, any number of turns.
  Vec2 pivot = Vec2::Zero();      ///< The pivot, in the polygon's frame.

  /// At rest.
  static Motion still(const Pose& pose);
  /// A shift without a turn.
  static Motion translation(const Pose& start, const Vec2& shift);
  /// From pose to pose, with a turn in (-pi, pi] and the pivot on a straight line. at(1) is `end` up to rounding, and
  /// up to how far the two linear parts differ by more than a rotation. Throws std::invalid_argument, naming the field,
  /// for a pose that checkPose() refuses, for two poses of which only one mirrors, and for a pivot that is not finite.
  static Motion between(const Pose& start, const Pose& end, const Vec2& pivot = Vec2::Zero());

  /// The pose at `time`, rounded. At 0 it is exactly `start`.
  Pose at(double time) const;
};

/// Throws std::invalid_argument, naming `name` and the field, unless all of the motion is finite and start is rigid.
///
/// \snippet motion.cpp check motion
TRICOVER_EXPORT void checkMotion(const Motion& motion, const char* name = "motion");

}  // namespace tricover
