// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "tricover/depth.h"

namespace tricover::detail {

/// What is asked of a depth: all of it, or whether it is below, exactly, or above a value.
struct DepthWish {
  double beside = std::numeric_limits<double>::infinity();
};

/// depth() of operands in the kernel's order that collide. With a wish, a depth may stand for another one that compares
/// with that value in the same way.
Depth depthInOrder(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                   const DepthWish& wish);

}  // namespace tricover::detail
