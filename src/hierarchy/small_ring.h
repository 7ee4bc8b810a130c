// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "hierarchy/hierarchy.h"
#include "polygon/convexity.h"

namespace tricover::detail {

/// A polygon that is a single ring of few vertices, otherwise null; `local` is its path in units, from S.
std::unique_ptr<const SmallRing> makeSmallRing(const PolygonData& polygon, const Convexity& convexity,
                                               const std::vector<Vec2>& local);

}  // namespace tricover::detail
