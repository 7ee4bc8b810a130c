// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/prepare.h"

#include "contact/disc_cover.h"
#include "contact/own_crossings.h"
#include "convex/convex_outline.h"
#include "hierarchy/hierarchy.h"
#include "hierarchy/inclusion.h"
#include "pair/ring_starts.h"
#include "polygon/convexity.h"

namespace tricover {

void prepare(const Polygon& polygon) {
  const detail::PolygonData& data = polygon.data();
  detail::hierarchyOf(data);
  if (data.isDegenerate()) return;
  detail::innerDiscsOf(data);
  if (detail::convexityOf(data).direction != 0)
    detail::convexOutlineOf(data);
  else
    detail::discCoverOf(data);
  detail::meetsItself(data);
  detail::buildPlaces(data);
  detail::buildRingStarts(data);
}

}  // namespace tricover
