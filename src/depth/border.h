// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "polygon/polygon_data.h"

namespace tricover::detail {

/// The closure of the polygon's interior, under the even-odd rule: each of its edges has the region on one side alone.
/// The polygon itself where that is true of it; null if there is no interior. Where rings of the non-zero rule cross
/// away from vertices, corners are rounded. Built at the first call, once for all copies and threads.
const PolygonData* withBordersOnly(const PolygonData& polygon);
/// The same as a polygon; a polygon without interior as it is.
Polygon bordersOf(const Polygon& polygon);
/// Its edges, each as a segment: a region without interior.
Polygon wallsOf(const Polygon& polygon);
/// The edge of the polygon that an edge of that region is a piece of, by their positions.
EdgePosition givenEdge(const PolygonData& polygon, const PolygonData& region, EdgePosition position);

}  // namespace tricover::detail
