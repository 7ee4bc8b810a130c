// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/pose.h"

namespace tricover {

/// A planar rigid motion over time 0 to 1: the polygon turns at a constant rate about a pivot of its own, which moves
/// at a constant velocity. Pure translation (angle 0), interpolation between poses (any pivot) and the plane's screw
/// (shift 0: a rotation about a fixed point) are all of this kind.
struct Motion {
  Pose start = Pose::Identity();  ///< at time 0; from the polygon's frame to the world
  Vec2 shift = Vec2::Zero();      ///< of the pivot, in the world, from time 0 to 1
  double angle = 0;               ///< radians, counter-clockwise in the world, any number of turns
  Vec2 pivot = Vec2::Zero();      ///< in the polygon's frame

  /// At rest.
  static Motion still(const Pose& pose);
  /// start's rotation is kept.
  static Motion translation(const Pose& start, const Vec2& shift);
  /// From pose to pose with the turn in (-pi, pi] and the pivot on a straight line. at(1) is `end` up to rounding and
  /// to what the linear parts differ by beside a rotation. Throws std::invalid_argument, naming the field, for poses
  /// that checkPose() refuses, of which only one mirrors, or a pivot that isn't finite.
  static Motion between(const Pose& start, const Pose& end, const Vec2& pivot = Vec2::Zero());

  /// The pose at `time`, rounded; exactly `start` at 0.
  Pose at(double time) const;
};

/// Throws std::invalid_argument, naming `name` and the field, unless all of it is finite and start is rigid.
void checkMotion(const Motion& motion, const char* name = "motion");

}  // namespace tricover
