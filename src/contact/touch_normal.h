// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "contact/overlap_components.h"

namespace tricover::detail {

/// Of a component's crossings the one whose edges have the longest stretch in common.
std::size_t longestStretch(const WorldFrame& frame, const std::vector<EdgeCrossing>& crossings,
                           const OverlapComponent& component);

/// From a to b. Where edges touch along a stretch, across these; where there is but a point, that of `main`, of the
/// normals of its edges the one that both polygons' edges keep to their sides of best, among equal ones that nearest to
/// `towards_b`.
Vec2 touchNormal(const WorldFrame& frame, const std::vector<EdgeCrossing>& crossings, const OverlapComponent& component,
                 const EdgeCrossing& main, const Vec2& towards_b);

}  // namespace tricover::detail
