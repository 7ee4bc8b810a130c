// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/prepare.h"

#include "convex/convex_outline.h"
#include "hierarchy/influence_field.h"
#include "overlay/rings.h"
#include "pair/ring_starts.h"

namespace tricover {

void prepare(const Polygon& polygon) {
  const detail::PolygonData& data = detail::dataOf(polygon);
  detail::hierarchyOf(data);
  detail::innerDiscsOf(data);
  if (hasField(data)) fieldOf(data);
  detail::convexOutlineOf(data);
  if (const detail::PolygonData* corners = detail::cornersOf(data)) {
    detail::hierarchyOf(*corners);
    detail::innerDiscsOf(*corners);
    detail::convexityOf(*corners);
    detail::buildRingStarts(*corners);
  }
  detail::meetsItself(data);
  detail::regionSidesOf(data);
  detail::buildRingStarts(data);
}

}  // namespace tricover
