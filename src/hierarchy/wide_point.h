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

/// The shares of a way at which it enters the boxes grown by `reach` (their corners, too), from 0 on; above 1e29 where
/// it doesn't. A way along a side is divided by nearly 0: then either both ends of the slab are beyond, or neither.
template <class Lanes>
[[gnu::always_inline]] inline Lanes boxEntries(const Block& block, float x, float y, float dx, float dy, float reach) {
  const Lanes ux = Lanes::load(block.ux), uy = Lanes::load(block.uy);
  const Lanes ex = Lanes::load(block.x) - x, ey = Lanes::load(block.y) - y;
  const Lanes along = Lanes::load(block.along) + reach, across = Lanes::load(block.across) + reach;
  const Lanes along_at = ex * ux + ey * uy, across_at = ey * ux - ex * uy;
  const Lanes along_by = ux * dx + uy * dy + 1e-30f, across_by = ux * dy - uy * dx + 1e-30f;
  const Lanes s = (along_at - along) / along_by, t = (along_at + along) / along_by;
  const Lanes v = (across_at - across) / across_by, w = (across_at + across) / across_by;
  const Lanes entry = larger(larger(smaller(s, t), smaller(v, w)), Lanes::all(0));
  const Lanes exit = smaller(larger(s, t), larger(v, w));
  // Where it leaves before it enters, the difference is positive, and so is far too much of it.
  return entry + larger(entry - exit, Lanes::all(0)) * 1e38f;
}

template <class Lanes>
void visitEdgesOnWay(const Hierarchy& hierarchy, const Way& way, double (*visit)(void*, std::uint32_t), void* context) {
  std::uint32_t stack[(kLanes - 1) * kMaxDepth + 1];
  float entries[(kLanes - 1) * kMaxDepth + 1];
  int top = 0;
  stack[top] = 0;
  entries[top++] = 0;
  double first = 1;
  while (top > 0) {
    if (entries[--top] > first) continue;
    const Block& block = hierarchy.blocks[stack[top]];
    const PlaceInBlock p = placeIn(block, way.start);
    const double dx = way.dx * block.inverse, dy = way.dy * block.inverse;
    const double reach = way.reach * block.inverse + p.slack + 2 * kGapRounding * (magnitude(dx) + magnitude(dy));
    unsigned near = (1u << block.count) - 1;
    float entry[kLanes] = {};
    if (reach < 1e15) {
      const Lanes found = boxEntries<Lanes>(block, p.x, p.y, static_cast<float>(dx), static_cast<float>(dy),
                                            static_cast<float>(reach) * (1 + 0x1p-20f));
      near &= ~above(found, Lanes::all(static_cast<float>(first)));
      found.store(entry);
    }
    int nearest = top;
    float least = 1e38f;
    for (; near != 0; near &= near - 1) {
      const int i = __builtin_ctz(near);
      if (block.leaf) {
        if (!(entry[i] > first)) first = visit(context, block.child[i]);
        continue;
      }
      if (entry[i] < least) {
        least = entry[i];
        nearest = top;
      }
      stack[top] = block.child[i];
      entries[top++] = entry[i];
    }
    if (nearest >= top) continue;
    const std::uint32_t last = stack[top - 1];
    const float last_entry = entries[top - 1];
    stack[top - 1] = stack[nearest];
    entries[top - 1] = entries[nearest];
    stack[nearest] = last;
    entries[nearest] = last_entry;
  }
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
