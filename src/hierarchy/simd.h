// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <type_traits>

#include "hierarchy/hierarchy.h"
#include "hierarchy/simd_function.h"
#include "hierarchy/unit_map.h"
#include "numbers/double2.h"
#include "numbers/double_double.h"
#include "polygon/edge_walk.h"

namespace tricover::detail {

/// Two hierarchies, each with its polygon, as a descent sees them. Lengths are in a's units.
struct Descent {
  const PolygonData &polygon_a, &polygon_b;
  const Hierarchy &a, &b;
  const UnitMap& to_a;
  double limit;             ///< boxes beyond aren't entered
  bool degenerate = false;  ///< whether a degenerate polygon is taken for its one edge alone
};

/// Which edges make a hit. Lengths are in a's units.
struct HitTest {
  const void* context;
  bool (*meet)(const void* context, EdgePosition edge_a, EdgePosition edge_b);  ///< edges by their positions
  double reach;                                                                 ///< edges beyond can't make a hit
  double accept;  ///< regions that are proven closer are a hit without asking edges; negative: never
  bool wants_clearance;
};

struct DescentResult {
  bool hit;
  double clearance;             ///< no pair of edges is nearer, if there is no hit
  EdgePosition edge_a, edge_b;  ///< of a hit; kNoEdge if `accept` answered
};

/// The first pair of edges that makes a hit, deepest box first.
extern Simd<DescentResult(const Descent& descent, const HitTest& test)> findHit;

/// Calls visit(context, edge's position) for the edges that may be within `reach` of a point, as far as they are
/// `marked`: a bit for each lane of each block, which in a block with children says that a child has a marked lane.
extern Simd<void(const Hierarchy& hierarchy, const Place& place, double reach, const std::uint8_t* marked,
                 void (*visit)(void*, std::uint32_t), void* context)>
    visitMarkedNear;

/// Which edge near a point makes a hit. Lengths are in the hierarchy's units.
struct NearEdgeTest {
  const void* context;
  bool (*meet)(const void* context, EdgePosition edge);
  double reach;   ///< edges beyond can't make a hit
  double accept;  ///< an edge that is proven to be no farther away is a hit without being asked; negative: never
};

/// The first edge found that makes a hit. Without one, `clearance` is a lower bound of the distance from the point to
/// any edge, at most the limit.
extern Simd<DescentResult(const Hierarchy& hierarchy, const Place& place, double limit, const NearEdgeTest& test)>
    findEdgeNear;

/// A lower bound of that distance, looked for within `most`.
inline double clearanceAt(const Hierarchy& hierarchy, const Place& place, double most) {
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  return findEdgeNear(hierarchy, place, most, {nullptr, nullptr, kNone, kNone}).clearance;
}

/// The edges that may be the nearest to a point, as floats see it; how many, 0 if that isn't known or there are more.
constexpr int kMostNearest = 8;
extern Simd<int(const Hierarchy& hierarchy, const Place& place, std::uint32_t (&edges)[kMostNearest])> findNearestEdges;

/// Points that move straight, each with a reach of its own.
struct StraightPaths {
  static constexpr int kMost = SmallPolygon::kMost;
  float x[kMost], y[kMost], to_x[kMost], to_y[kMost], reach[kMost];
  int count;
};
/// Of each point a bit for every edge that it may come within its reach of. Nothing may exceed 2^30, in units.
extern Simd<void(const SmallPolygon& polygon, const StraightPaths& paths, unsigned* near)> findEdgesOnPaths;

/// A box, or an edge as a box without width, at both ends of an interval of time, one a lane: its centre, the images of
/// its axes, near unit length, and its half extents along them.
struct MovingBox {
  Double2 x, y, ux, uy, vx, vy;
  double along, across;
};
/// Relative to the sum of what a gap is computed from, as for kGapRounding.
constexpr double kMovingGapRounding = 4 * kGapRounding;
/// A bit for each of the block's boxes that another box may meet, and the shares of the interval, from its begin and
/// from its end, in which they don't. The box is in the block's scale from its origin, in the frame that turns with the
/// block; IntervalCutter's chord errors are those along axes that turn with the block and with the box; a gap must
/// exceed the slack. Nothing may exceed 2^30.
extern Simd<unsigned(const Block& block, const MovingBox& moving, double chord_error_with_block,
                     double chord_error_with_box, double slack, float* from_begin, float* from_end)>
    cutIntervals;

/// How deep, in units, a point is at least in one of the discs: negative where it may be beside all, by no less than
/// what it may be away from the nearest.
extern Simd<double(const InnerDiscs& discs, const Place& place)> depthInDiscs;

/// Lengths in a's units. Both return the limit beyond which no more pairs need to be shown; negative ends the visit.
struct PairVisitor {
  void* context;
  /// Edges at these positions, whose distance is at least `gap`.
  double (*visit)(void* context, double gap, EdgePosition edge_a, EdgePosition edge_b);
  /// Null, or told a length that some pair's distance is proven not to be above.
  double (*narrow)(void* context, double length);
};

/// Shows every pair of edges that may be within the limit, near ones roughly first.
extern Simd<void(const Descent& descent, const PairVisitor& visitor)> showPairs;

/// How deep, in a's units, some inner disc of a and one of b overlap at least; not positive if none is proven to. `map`
/// as for fewEdgesMeet().
extern Simd<double(const InnerDiscs& a, const InnerDiscs& b, const UnitMap& map)> innerDepth;

enum class Meeting { Apart, Meet, Unknown };

/// Which edge of two small convex polygons has all of the other farthest beyond it, how far, in a's units, and which
/// vertex of the other is nearest to its line. It is a guess as good as floats.
struct ConvexGap {
  float gap;
  EdgePosition edge, vertex;
  bool of_a;
};

/// Whether two edges meet, by their positions: who knows where floats don't. Null: nobody.
struct EdgeCheck {
  const void* context = nullptr;
  bool (*meet)(const void* context, EdgePosition edge_a, EdgePosition edge_b) = nullptr;
};

/// Two small polygons by all of their edges, where floats are certain or few pairs of edges need the check. `map` goes
/// from b's units to a's and puts b's S within 4 of a's.
extern Simd<Meeting(const SmallPolygon& a, const SmallPolygon& b, const UnitMap& map, const EdgeCheck& check)>
    fewEdgesMeet;

/// Whether fewEdgesMeet() is for them.
inline bool areSmall(const Hierarchy& a, const Hierarchy& b) { return a.small && b.small; }

extern Simd<ConvexGap(const SmallPolygon& a, const SmallPolygon& b, const UnitMap& map)> convexGap;

/// The same of which edge parts the two longest, by more than a margin, while b moves straight by (way_x, way_y),
/// both in a's units: the gap is the share of the way.
extern Simd<ConvexGap(const SmallPolygon& a, const SmallPolygon& b, const UnitMap& map, double way_x, double way_y,
                      double margin)>
    convexEntry;

/// Edges of two small convex polygons that cross, a guess as good as floats; or one edge alone of the
/// polygon that is proven to lie inside the other; or none. `map` as for fewEdgesMeet().
struct ConvexCrossing {
  EdgePosition edge_a = kNoEdge, edge_b = kNoEdge;
};
extern Simd<ConvexCrossing(const SmallPolygon& a, const SmallPolygon& b, const UnitMap& map)> convexCrossing;

/// R_b q + t_b - t_a - R_a p of two poses' columns, times a power of two: right to 100 U^2 of what is summed.
extern Simd<void(const double* pose_a, Double2 p, const double* pose_b, Double2 q, double scale, Twofold<Double2>& way)>
    twofoldWay;
/// R (q - p) x way, and the first of these, rounded.
extern Simd<double(const double* pose, Double2 p, Double2 q, const Twofold<Double2>& way, Double2& along)> twofoldArea;

/// A ray in a hierarchy's units: every point known to within `error`, which may be a moving disc's radius, too.
struct Ray {
  double x = 0, y = 0, dx = 1, dy = 0, error = 0;
  double length = std::numeric_limits<double>::infinity();  ///< where it ends
  bool for_winding = false;                                 ///< whether it tells only what winds around its begin
};

/// Calls visit(context, edge's position) for every edge that the ray may meet, the first roughly first, until it
/// returns false. It may shorten the ray. Rings whose boxes don't hold the begin of a ray that is `for_winding` may be
/// left out.
extern Simd<void(const Hierarchy& hierarchy, const Ray& ray, bool (*visit)(void*, std::uint32_t), void* context)>
    visitEdgesOnRay;

/// Calls visit(edge), a position, until it returns false, for every edge that a ray may meet, the first roughly first;
/// without a ray (null) for every edge. The visit may shorten the ray.
template <typename Visit>
void forEachEdgeOn(const PolygonData& polygon, const Ray* ray, Visit&& visit) {
  if (ray == nullptr) return forEachEdge(polygon, visit);
  const auto call = [](void* context, EdgePosition edge) {
    return (*static_cast<std::remove_reference_t<Visit>*>(context))(edge);
  };
  visitEdgesOnRay(hierarchyOf(polygon), *ray, call, &visit);
}

/// The same for every edge that may come within `reach` of the segment between two points, in units. Where these are
/// wrong, in any direction, the reach has to hold that, too.
template <typename Visit>
void forEachEdgeNear(const PolygonData& polygon, const Vec2& from, const Vec2& to, double reach, Visit visit) {
  const Vec2 way = to - from;
  const double length = way.norm(), rounding = 0x1p-46 * (from.lpNorm<1>() + length + 4);
  Ray ray{from.x(), from.y(), 1, 0, reach + rounding, length};
  if (length > 0x1p-400) ray.dx = way.x() / length, ray.dy = way.y() / length;
  const bool is_known = polygon.fitsUnit() && ray.error < 0x1p1000 && length < 0x1p1000;
  forEachEdgeOn(polygon, is_known ? &ray : nullptr, visit);
}

}  // namespace tricover::detail
