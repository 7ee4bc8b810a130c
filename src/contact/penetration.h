// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "polygon/polygon_data.h"
#include "tricover/penetration.h"

namespace tricover::detail {

/// Whether the regions are farther apart than the margin once the poses, in the kernel's order, have been translated
/// so. Exact.
bool areApartMoved(const PolygonData& a, Pose pose_a, const Vec2& by_a, const PolygonData& b, Pose pose_b,
                   const Vec2& by_b, double margin);

/// penetration() of operands that are known to overlap, but for the margin, in the kernel's order.
Penetration penetrationInOrder(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                               const PenetrationOptions& options);

}  // namespace tricover::detail
