// SPDX-License-Identifier: BSD-3-Clause
// One hierarchy descended around a point. See wide_gaps.h for Lanes.
#pragma once

#include "hierarchy/wide_gaps.h"

namespace tricover::detail::wide {

/// A place as a block sees it.
struct PlaceInBlock {
  float x, y;
  float slack;  ///< what a distance may be wrong by
};

[[gnu::always_inline]] inline PlaceInBlock placeIn(const Block& block, const Place& place) {
  const double x = (place.x - block.origin_x) * block.inverse, y = (place.y - block.origin_y) * block.inverse;
  const double slack = kGapRounding * (magnitude(x) + magnitude(y) + 4) + place.error * block.inverse;
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(slack)};
}

static_assert(kGapRounding >= (1.5 * (6 + 2) + 4 + 6) * kFloatRoundoff);

/// Distances of a point from eight boxes. In the terms of kGapRounding: along either axis a difference of coordinates
/// is rounded 6 times, an extent twice, both of at most |x| + |y| + 4; 1.5 times that for the root of two squares,
/// which itself rounds 4 times, and 6 for what adds up and is compared.
template <class Lanes>
[[gnu::always_inline]] inline Lanes boxDistances(const Block& block, const PlaceInBlock& p) {
  const Lanes ux = Lanes::load(block.ux), uy = Lanes::load(block.uy), zero = Lanes::all(0);
  const Lanes dx = Lanes::load(block.x) - p.x, dy = Lanes::load(block.y) - p.y;
  const Lanes along = larger(absolute(dx * ux + dy * uy) - Lanes::load(block.along), zero);
  const Lanes across = larger(absolute(dy * ux - dx * uy) - Lanes::load(block.across), zero);
  return root(along * along + across * across);
}

/// The nearest first: the least distance goes on top.
[[gnu::always_inline]] inline void pushNearestLast(const Block& block, unsigned near, const float* distance,
                                                   std::uint32_t* stack, int& top) {
  int nearest = top;
  float least = 1e38f;
  for (; near != 0; near &= near - 1) {
    const int i = __builtin_ctz(near);
    if (distance[i] < least) {
      least = distance[i];
      nearest = top;
    }
    stack[top++] = block.child[i];
  }
  const std::uint32_t last = stack[top - 1];
  stack[top - 1] = stack[nearest];
  stack[nearest] = last;
}

template <class Lanes>
DescentResult findEdgeNear(const Hierarchy& hierarchy, const Place& place, double limit, const NearEdgeTest& test) {
  std::uint32_t stack[(kLanes - 1) * kMaxDepth + 1];
  int top = 0;
  stack[top++] = 0;
  DescentResult result{false, limit > 0 ? limit : 0, -1, -1};
  while (top > 0) {
    const Block& block = hierarchy.blocks[stack[--top]];
    const PlaceInBlock p = placeIn(block, place);
    // Rounded upwards, as in stepOf().
    const float threshold = static_cast<float>(limit * block.inverse + p.slack) * (1 + 0x1p-20f);
    const bool known = p.slack < 1e15f && threshold < 1e15f;  // squares don't overflow
    const Lanes found = boxDistances<Lanes>(block, p);
    unsigned near = (1u << block.count) - 1;
    if (known) near &= ~above(found, Lanes::all(threshold));
    if (near == 0) continue;
    float distance[kLanes];
    found.store(distance);
    if (!block.leaf) {
      pushNearestLast(block, near, distance, stack, top);
      continue;
    }
    for (; near != 0; near &= near - 1) {
      const int i = __builtin_ctz(near);
      const double low = known ? (static_cast<double>(distance[i]) - p.slack) * block.scale : 0;
      // No point of a leaf's box is farther than twice its extent across from its edge.
      const double high = (static_cast<double>(distance[i]) + 2.0 * block.across[i] + p.slack) * block.scale;
      if (low < result.clearance) result.clearance = low > 0 ? low : 0;
      if (low > test.reach) continue;
      if ((known && high <= test.accept) || test.meet(test.context, block.child[i]))
        return {true, 0, static_cast<std::int64_t>(block.child[i]), -1};
    }
  }
  return result;
}

/// Rounding as in boxDistances(); the radii, below 2, are floats.
template <class Lanes>
double depthInDiscs(const InnerDiscs& discs, const Place& place) {
  const double slack = kGapRounding * (magnitude(place.x) + magnitude(place.y) + 4) + place.error;
  if (!(slack < 1)) return -1e30;
  const Lanes dx = Lanes::load(discs.x) - static_cast<float>(place.x),
              dy = Lanes::load(discs.y) - static_cast<float>(place.y);
  float depth[kLanes];
  (Lanes::load(discs.radius) - root(dx * dx + dy * dy)).store(depth);
  float deepest = depth[0];
  for (int i = 1; i < kLanes; ++i) deepest = depth[i] > deepest ? depth[i] : deepest;
  return deepest - slack;
}

}  // namespace tricover::detail::wide
