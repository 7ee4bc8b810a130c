// SPDX-License-Identifier: BSD-3-Clause
#include "distance/ring_distance.h"

#include <algorithm>
#include <cmath>

#include "hierarchy/simd.h"
#include "pair/placement.h"

namespace tricover::detail {
namespace {

/// In a's units: what is farther is left to boxes.
constexpr double kFarRings = 64;
/// Up to here smallMeet() tells; from here on the bounding discs, of at most a unit each, are apart.
constexpr double kNearRings = 4;

bool areApart(const SmallPolygon& a, const SmallPolygon& b, const UnitMap& map, double rounding, double far) {
  if (far >= kNearRings) return map.error < 0.5;
  return smallMeet(a, b, map, rounding) == Meeting::Apart;
}

}  // namespace

// Of a vertex and an edge, floats know how far away it is from the edge's line, and how far along that past its ends:
// the first as convexMeet() does, within 8 roundings of a gap and the map's error while coordinates are below 8; that
// grows with them. The other takes the middle and a half more, twice as much. Their root is off by no more than the two
// together, and by a few roundings of its own. As a's frame has it, it is a length in the world but for the scale's
// defect, and so are two that are compared.
bool showSmall(const PosedPair& pair, DistanceSearch& search) {
  if (!areSmall(pair.a, pair.b)) return false;
  const SmallPolygon *a = hierarchyOf(pair.a).small.get(), *b = hierarchyOf(pair.b).small.get();
  const UnitPlacement at(pair);
  const UnitMap& map = at.map;
  const double rounding = at.rounding, far = std::abs(map.tx) + std::abs(map.ty);
  if (!(far < kFarRings && areApart(*a, *b, map, rounding, far))) return false;
  SmallGaps gaps;
  smallGaps(*a, *b, map, gaps);
  const double slack = 4 * (8 * rounding + map.error) * (1 + far / kNearRings);
  const double factor = 1 + 32 * kFloatRoundoff + 4 * pair.scale_defect;
  search.limitTo((std::sqrt(static_cast<double>(gaps.least)) * factor + slack) * factor * pair.a.unit);
  const double reach = pair.reach(EdgeDistances::above(search.reach())) * pair.a.inverse_unit;
  const double within = std::min(reach, 2 * kFarRings) * factor + slack;
  unsigned near[SmallPolygon::kMost];
  edgesWithin(*a, *b, gaps, static_cast<float>(within * within * factor), near);
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
