// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/depth.h"

namespace tricover::detail {

/// depth() of operands in the kernel's order. The search may end at any depth above `enough`.
Depth depthInOrder(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b, double enough);

}  // namespace tricover::detail
