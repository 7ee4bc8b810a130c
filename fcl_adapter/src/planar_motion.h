// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/math/motion/motion_base.h>

#include "planar_pose.h"
#include "tricover/motion.h"

namespace tricover_fcl {

/// A motion in space that keeps the plane, and its height.
struct PlanarMotion {
  tricover::Motion motion;
  PlanarPose start, end;  ///< as FCL rounds them
};

/// Of FCL's TranslationMotion, InterpMotion and ScrewMotion; these types exactly. Throws UnsupportedPair for others,
/// and std::invalid_argument for motions that leave the plane. Leaves the motion's current transform anywhere, as FCL
/// does.
template <typename S>
PlanarMotion planarMotion(const fcl::MotionBase<S>& motion, const char* name);

}  // namespace tricover_fcl
