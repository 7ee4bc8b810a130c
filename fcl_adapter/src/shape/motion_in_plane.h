// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/math/motion/motion_base.h>

#include "shape/plane.h"
#include "tricover/motion.h"

namespace tricover_fcl {

/// What to do where conservative advancement has no answer.
constexpr const char* kSampleInstead =
    "use fcl::continuousCollide with CCDC_NAIVE, which asks collide at several times";

/// The pose at `time` as FCL rounds it.
template <typename S>
fcl::Transform3<S> poseAt(const fcl::MotionBase<S>& motion, S time);

/// What the motion does to things in `plane`, in its coordinates: from where they are at time 0, so it starts with the
/// identity. For FCL's TranslationMotion, InterpMotion, ScrewMotion and SplineMotion; these types exactly. Throws std::logic_error
/// for others, and std::invalid_argument if it leaves the plane or isn't finite, both naming the motion.
template <typename S>
tricover::Motion motionInPlane(const fcl::MotionBase<S>& motion, const Plane& plane, const char* name);

}  // namespace tricover_fcl
