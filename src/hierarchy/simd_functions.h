// SPDX-License-Identifier: BSD-3-Clause
// All that is a template over the lanes, for an instruction set to instantiate.
#pragma once

#include "hierarchy/simd_boxes.h"
#include "hierarchy/simd_descent.h"
#include "hierarchy/simd_point.h"
#include "hierarchy/simd_shapes.h"
#include "hierarchy/simd_small.h"
#include "hierarchy/simd_small_gaps.h"
#include "hierarchy/simd_table.h"
#include "hierarchy/simd_ways.h"
#include "hierarchy/simd_windows.h"

namespace tricover::detail::simd {

template <class Lanes>
constexpr SimdTable tableOf() {
  return {&findHit<Lanes>,      &showPairs<Lanes>,       &visitEdgesOnRay<Lanes>,  &convexMeet<Lanes>,
          &innerDepth<Lanes>,   &findEdgeNear<Lanes>,    &depthInDiscs<Lanes>,     &visitEdgesOnWay<Lanes>,
          &convexGap<Lanes>,    &showEdgesNear<Lanes>,   &findNearestEdges<Lanes>, &convexCrossing<Lanes>,
          &fewEdgesMeet<Lanes>, &findEdgesOnWays<Lanes>, &convexEntry<Lanes>,      &boxesMeeting<Lanes>,
          &boxesOnRay<Lanes>,   &cutWindows<Lanes>,      &smallGaps<Lanes>,        &nearEdges<Lanes>};
}

}  // namespace tricover::detail::simd
