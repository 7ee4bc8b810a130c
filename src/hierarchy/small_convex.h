// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "hierarchy/hierarchy.h"

namespace tricover::detail {

/// The half planes of a polygon that is proven to be convex and has few vertices, otherwise null; `local` is its path
/// in units, from S.
std::unique_ptr<const SmallConvex> makeSmallConvex(const PolygonData& polygon, const std::vector<Vec2>& local);

}  // namespace tricover::detail
