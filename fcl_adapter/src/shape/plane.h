// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/common/types.h>

namespace tricover_fcl {

/// A plane in space with coordinates of its own: maps (x, y, 0) to the world.
using Plane = fcl::Transform3<double>;

/// The world's plane at height z.
inline Plane planeAt(double z) { return Plane(fcl::Translation3<double>(0, 0, z)); }

}  // namespace tricover_fcl
