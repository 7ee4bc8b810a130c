// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hierarchy/hierarchy.h"
#include "pair/posed_pair.h"

/// Descents of the hierarchy, eight boxes at a time. wide_body.h has them once; wide.cpp compiles it for AVX2 and for
/// whatever the target has (SSE2, NEON), and picks by what the processor has. No operation is fused or reordered, so
/// both give the same bits.
namespace tricover::detail {

/// p -> scale r p + t, from one hierarchy's units to the other's.
struct UnitMap {
  double r00, r01, r10, r11, tx, ty, scale;
  double error;  ///< a mapped point is no farther than this from the true one
};

/// What a descent of two hierarchies needs to know. Lengths are in a's units.
struct Descent {
  const PosedPair& pair;
  const Hierarchy &a, &b;
  UnitMap to_a;
  double rounding;           ///< of a gap in a block's scale, relative to the coordinates it is computed from
  double reach;              ///< edges beyond can't make a hit
  double limit;              ///< boxes beyond aren't entered: reach + lookahead
  double accept;             ///< regions that are proven closer are a hit without asking edges; negative: never
  double margin, tolerance;  ///< world lengths, for the edges
  bool wants_clearance;
};

/// The way back. Entries of R are wrong by 9U, those of its inverse by 13U.
UnitMap inverse(const UnitMap& map);

struct DescentResult {
  bool hit;
  double clearance;             ///< no pair of edges is nearer, if there is no hit
  std::int64_t edge_a, edge_b;  ///< of a hit; -1 if `accept` answered
};

/// Deepest box first.
DescentResult descend(const Descent& descent);

/// Lengths in a's units. Both return the limit beyond which no more pairs need to be shown; negative ends the visit.
struct PairVisitor {
  void* context;
  /// Edges at these positions, whose distance is at least `gap`.
  double (*visit)(void* context, double gap, std::uint32_t edge_a, std::uint32_t edge_b);
  /// Null, or told a length that some pair's distance is proven not to be above.
  double (*narrow)(void* context, double length);
};

/// Shows every pair of edges that may be within the limit, near ones roughly first. Of the descent, only its limit
/// counts.
void visitPairs(const Descent& descent, const PairVisitor& visitor);

/// How deep, in a's units, some inner disc of a and one of b overlap at least; not positive if none is proven to. `map`
/// as for convexMeet().
double innerDepth(const InnerDiscs& a, const InnerDiscs& b, const UnitMap& map, double rounding);

enum class Meeting { Apart, Meet, Unknown };

/// Two small convex polygons by separating axes. `map` goes from b's units to a's and puts b's S within 4 of a's.
Meeting convexMeet(const SmallConvex& a, const SmallConvex& b, const UnitMap& map, double rounding);

/// A ray in a hierarchy's units: every point known to within `error`, for as far as the hierarchy reaches.
struct Ray {
  double x, y, dx, dy, error;
};

/// Calls visit(context, edge's position) for every edge that the ray may meet, until it returns false.
void visitEdgesOnRay(const Hierarchy& hierarchy, const Ray& ray, bool (*visit)(void*, std::uint32_t), void* context);

/// For tests: true forbids AVX2 for the whole process.
void usePortableLanes(bool portable);

}  // namespace tricover::detail
