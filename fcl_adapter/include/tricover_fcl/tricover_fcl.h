// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover_fcl/collide.h"
#include "tricover_fcl/continuous_collide.h"
#include "tricover_fcl/distance.h"
#include "tricover_fcl/fcl_layout.h"
#include "tricover_fcl/polygon_object.h"
#include "tricover_fcl/polygon_shape.h"
#include "tricover_fcl/registration.h"
#include "tricover_fcl/scene_manager.h"
#include "tricover_fcl/trajectory_motion.h"

/// tricover's polygons as shapes of FCL, and FCL's queries about them.
namespace tricover_fcl {}
