// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "polygon/polygon_data.h"
#include "tricover/pose.h"
#include "tricover/ray_hit.h"

namespace tricover::detail {

/// Throws for an end that is not finite.
void requireFiniteRay(const Vec2& from, const Vec2& to);

/// tricover::castRay() without a margin for operands that have been checked. Nothing where the hit's fraction is above
/// `limit`, which spares time; up to the limit the answer doesn't depend on it.
std::optional<RayHit> castPlainRay(const PolygonData& polygon, const Pose& pose, const Vec2& from, const Vec2& to,
                                   double limit);

/// tricover::castRayAll() without a margin for operands that have been checked.
std::vector<RayInterval> castPlainRayAll(const PolygonData& polygon, const Pose& pose, const Vec2& from,
                                         const Vec2& to);

}  // namespace tricover::detail
