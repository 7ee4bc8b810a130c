// SPDX-License-Identifier: BSD-3-Clause
#include "hierarchy/simd.h"

#include <atomic>

#include "hierarchy/simd_table.h"

namespace tricover::detail {
namespace {

const SimdTable* fastest() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2")) return &kAvx2Table;
#endif
  return &kPortableTable;
}

// Constant until this file's initialisers run, for static objects that ask questions in theirs.
std::atomic<const SimdTable*> chosen{&kPortableTable};
[[maybe_unused]] const bool initialised = (chosen.store(fastest(), std::memory_order_relaxed), true);

const SimdTable& table() { return *chosen.load(std::memory_order_relaxed); }

}  // namespace

DescentResult findHit(const Descent& descent, const HitTest& test) { return table().find_hit(descent, test); }

void showPairs(const Descent& descent, const PairVisitor& visitor) { table().show_pairs(descent, visitor); }

void visitEdgesOnRay(const Hierarchy& hierarchy, const Ray& ray, bool (*visit)(void*, std::uint32_t), void* context) {
  table().visit_edges_on_ray(hierarchy, ray, visit, context);
}

Meeting convexMeet(const SmallPolygon& a, const SmallPolygon& b, const UnitMap& map, double rounding) {
  return table().convex_meet(a, b, map, rounding);
}

Meeting fewEdgesMeet(const SmallPolygon& a, const SmallPolygon& b, const UnitMap& map, double rounding,
                     const EdgeCheck& check) {
  return table().few_edges_meet(a, b, map, rounding, check);
}

void smallGaps(const SmallPolygon& a, const SmallPolygon& b, const UnitMap& map, SmallGaps& gaps) {
  table().small_gaps(a, b, map, gaps);
}

void nearEdges(const SmallPolygon& a, const SmallPolygon& b, const SmallGaps& gaps, float square,
               unsigned (&near)[SmallPolygon::kMost]) {
  table().near_edges(a, b, gaps, square, near);
}

double innerDepth(const InnerDiscs& a, const InnerDiscs& b, const UnitMap& map, double rounding) {
  return table().inner_depth(a, b, map, rounding);
}

DescentResult findEdgeNear(const Hierarchy& hierarchy, const Place& place, double limit, const NearEdgeTest& test) {
  return table().find_edge_near(hierarchy, place, limit, test);
}

int findNearestEdges(const Hierarchy& hierarchy, const Place& place, std::uint32_t (&edges)[kMostNearest]) {
  return table().find_nearest_edges(hierarchy, place, edges);
}

void showEdgesNear(const Hierarchy& hierarchy, const Place& place, double limit, std::uint32_t edge_b,
                   const PairVisitor& visitor) {
  table().show_edges_near(hierarchy, place, limit, edge_b, visitor);
}

void visitEdgesOnWay(const Hierarchy& hierarchy, const Way& way, double (*visit)(void*, std::uint32_t), void* context) {
  table().visit_edges_on_way(hierarchy, way, visit, context);
}

void findEdgesOnWays(const SmallPolygon& polygon, const FewWays& ways, unsigned* near) {
  table().find_edges_on_ways(polygon, ways, near);
}

unsigned cutWindows(const Block& block, const MovingQuery& query, float* from_begin, float* from_end) {
  return table().cut_windows(block, query, from_begin, from_end);
}

double depthInDiscs(const InnerDiscs& discs, const Place& place) { return table().depth_in_discs(discs, place); }

ConvexGap convexGap(const SmallPolygon& a, const SmallPolygon& b, const UnitMap& map) {
  return table().convex_gap(a, b, map);
}

ConvexGap convexEntry(const SmallPolygon& a, const SmallPolygon& b, const UnitMap& map, double way_x, double way_y) {
  return table().convex_entry(a, b, map, way_x, way_y);
}

ConvexCrossing convexCrossing(const SmallPolygon& a, const SmallPolygon& b, const UnitMap& map, double rounding) {
  return table().convex_crossing(a, b, map, rounding);
}

unsigned boxesMeeting(const EightBoxes& boxes, const Bounds& bounds) { return table().boxes_meeting(boxes, bounds); }

unsigned boxesOnRay(const EightBoxes& boxes, const BoxRay& ray, double most, double (&least)[kLanes]) {
  return table().boxes_on_ray(boxes, ray, most, least);
}

void usePortableLanes(bool portable) {
  chosen.store(portable ? &kPortableTable : fastest(), std::memory_order_relaxed);
}

}  // namespace tricover::detail
