// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "hierarchy/hierarchy.h"

namespace tricover::detail {

/// Makes one without edges, its lanes all 0.
std::unique_ptr<SmallPolygon> emptySmallPolygon(int lanes);

/// Null where the polygon has more edges, or one without a direction; `local` is its path in units, from S.
std::unique_ptr<const SmallPolygon> makeSmallPolygon(const PolygonData& polygon, const Vec2* local);

}  // namespace tricover::detail
