// SPDX-License-Identifier: BSD-3-Clause
#include "distance/small_distance.h"

#include <algorithm>
#include <cmath>

#include "hierarchy/placement.h"
#include "hierarchy/simd.h"

namespace tricover::detail {
namespace {

/// In a's units: what is farther is left to boxes.
constexpr double kFar = 64;
/// Up to here smallMeet() tells; from here on the bounding discs, of at most a unit each, are apart.
constexpr double kNear = 4;

bool areApart(const Hierarchy& a, const Hierarchy& b, const UnitMap& map, double rounding, double far) {
  if (far >= kNear) return map.error < 0.5;
  return smallMeet(a, b, map, rounding) == Meeting::Apart;
}

}  // namespace

// Of a vertex and an edge, floats know two lengths, while coordinates are below 8 (it grows with them):
//   beside the edge's line    right to 8 roundings of a gap and the map's error, as in convexMeet()
//   past the edge's ends      twice that: it takes the middle and a half more
// The root of their squares' sum is off by no more than both together, and by a few roundings of its own. It is a
// length of a's frame: in the world it differs by the scale's defect, and so do two that are compared.
bool showSmall(const PosedPair& pair, DistanceSearch& search) {
  if (!areSmall(pair.a, pair.b)) return false;
  const Hierarchy &tree_a = topOf(pair.a), &tree_b = topOf(pair.b);
  const UnitPlacement at = unitsOf(pair);
  const UnitMap& map = at.map;
  const double rounding = at.rounding, far = std::abs(map.tx) + std::abs(map.ty);
  if (!(far < kFar && areApart(tree_a, tree_b, map, rounding, far))) return false;
  const SmallPolygon *a = tree_a.small.get(), *b = tree_b.small.get();
  SmallGaps gaps;
  smallGaps(*a, *b, map, gaps);
  const double slack = 4 * (8 * rounding + map.error) * (1 + far / kNear);
  const double factor = 1 + 32 * kFloatRoundoff + 4 * pair.scale_defect;
  search.limitTo((std::sqrt(static_cast<double>(gaps.least)) * factor + slack) * factor * pair.a.unit);
  const double reach = pair.reach(EdgeDistances::above(search.reach())) * pair.a.inverse_unit;
  const double within = std::min(reach, 2 * kFar) * factor + slack;
  unsigned near[SmallPolygon::kMost];
  nearEdges(*a, *b, gaps, static_cast<float>(within * within * factor), near);
  for (int i = 0; i < a->count; ++i)
    for (unsigned of_b = near[i]; of_b != 0; of_b &= of_b - 1) {
      const std::uint32_t k = a->position[i], l = b->position[__builtin_ctz(of_b)];
      if (search.looksAhead())
        search.show(k, l);
      else
        search.showNear(k, l);
    }
  return true;
}

}  // namespace tricover::detail
