// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "tricover/ray.h"

namespace tricover::detail {

/// tricover::castRay() with a margin, for operands that have been checked: the impact of a point that moves along the
/// ray.
std::optional<RayHit> castRoundRay(const Polygon& polygon, const Pose& pose, const Vec2& from, const Vec2& to,
                                   double margin);

}  // namespace tricover::detail
