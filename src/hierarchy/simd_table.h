// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hierarchy/axis_boxes.h"
#include "hierarchy/simd.h"

namespace tricover::detail {

/// simd.h's and axis_boxes.h's functions for one instruction set.
struct SimdTable {
  decltype(&findHit) find_hit;
  decltype(&showPairs) show_pairs;
  decltype(&visitEdgesOnRay) visit_edges_on_ray;
  decltype(&convexMeet) convex_meet;
  decltype(&innerDepth) inner_depth;
  decltype(&findEdgeNear) find_edge_near;
  decltype(&depthInDiscs) depth_in_discs;
  decltype(&visitEdgesOnWay) visit_edges_on_way;
  decltype(&convexGap) convex_gap;
  decltype(&showEdgesNear) show_edges_near;
  decltype(&findNearestEdges) find_nearest_edges;
  decltype(&convexCrossing) convex_crossing;
  decltype(&fewEdgesMeet) few_edges_meet;
  decltype(&findEdgesOnWays) find_edges_on_ways;
  decltype(&convexEntry) convex_entry;
  decltype(&boxesMeeting) boxes_meeting;
  decltype(&boxesOnRay) boxes_on_ray;
  decltype(&cutWindows) cut_windows;
  decltype(&smallGaps) small_gaps;
  decltype(&nearEdges) near_edges;
};

/// Constant, so that static objects may ask questions before anything is initialised.
extern const SimdTable kPortableTable;
#ifdef __x86_64__
extern const SimdTable kAvx2Table;
#endif

}  // namespace tricover::detail
