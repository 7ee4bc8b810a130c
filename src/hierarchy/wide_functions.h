// SPDX-License-Identifier: BSD-3-Clause
// All that is a template over the lanes, for an instruction set to instantiate.
#pragma once

#include "hierarchy/wide_boxes.h"
#include "hierarchy/wide_descent.h"
#include "hierarchy/wide_point.h"
#include "hierarchy/wide_ring_gaps.h"
#include "hierarchy/wide_rings.h"
#include "hierarchy/wide_shapes.h"
#include "hierarchy/wide_table.h"
#include "hierarchy/wide_ways.h"
#include "hierarchy/wide_windows.h"

namespace tricover::detail::wide {

template <class Lanes>
constexpr WideTable tableOf() {
  return {&findHit<Lanes>,    &showPairs<Lanes>,       &visitEdgesOnRay<Lanes>,  &convexMeet<Lanes>,
          &innerDepth<Lanes>, &findEdgeNear<Lanes>,    &depthInDiscs<Lanes>,     &visitEdgesOnWay<Lanes>,
          &convexGap<Lanes>,  &showEdgesNear<Lanes>,   &findNearestEdges<Lanes>, &convexCrossing<Lanes>,
          &ringsMeet<Lanes>,  &findEdgesOnWays<Lanes>, &convexEntry<Lanes>,      &boxesMeeting<Lanes>,
          &boxesOnRay<Lanes>, &cutWindows<Lanes>,      &ringGaps<Lanes>,         &edgesWithin<Lanes>};
}

}  // namespace tricover::detail::wide
