// SPDX-License-Identifier: BSD-3-Clause
// A hierarchy and a point, still or moving. See simd_gaps.h for Lanes.
#pragma once

#include "hierarchy/descend.h"
#include "hierarchy/simd_gaps.h"

namespace tricover::detail::simd {

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
Lanes boxDistances(const Block& block, const PlaceInBlock& p) {
  const Lanes ux = Lanes::load(block.ux), uy = Lanes::load(block.uy), zero = Lanes::all(0);
  const Lanes dx = Lanes::load(block.x) - p.x, dy = Lanes::load(block.y) - p.y;
  const Lanes along = larger(absolute(dx * ux + dy * uy) - Lanes::load(block.along), zero);
  const Lanes across = larger(absolute(dy * ux - dx * uy) - Lanes::load(block.across), zero);
  return root(along * along + across * across);
}

template <class Lanes>
DescentResult findEdgeNear(const Hierarchy& hierarchy, const Place& place, double limit, const NearEdgeTest& test) {
  DescentResult result{false, limit > 0 ? limit : 0, kNoEdge, kNoEdge};
  PlaceInBlock p;
  bool known;
  const auto near = [&](const Block& block, float(&distance)[kLanes]) {
    p = placeIn(block, place);
    const float threshold = upwards(limit * block.inverse + p.slack);
    known = p.slack < 1e15f && threshold < 1e15f;  // squares don't overflow
    const Lanes found = boxDistances<Lanes>(block, p);
    found.store(distance);
    return known ? lanesOf(block) & ~above(found, Lanes::all(threshold)) : lanesOf(block);
  };
  const auto show = [&](const Block& block, unsigned lanes, const float* distance) {
    for (; lanes != 0; lanes &= lanes - 1) {
      const int i = __builtin_ctz(lanes);
      const double low = known ? (static_cast<double>(distance[i]) - p.slack) * block.scale : 0;
      // No point of a leaf's box is farther than twice its extent across from its edge.
      const double high = (static_cast<double>(distance[i]) + 2.0 * block.across[i] + p.slack) * block.scale;
      if (low < result.clearance) result.clearance = low > 0 ? low : 0;
      if (low > test.reach) continue;
      if ((known && high <= test.accept) || test.meet(test.context, block.child[i])) {
        result = {true, 0, block.child[i], kNoEdge};
        return false;
      }
    }
    return true;
  };
  descend<true>(
      hierarchy.blocks.data(), 0, [](float) { return true; }, near, show);
  return result;
}

template <class Lanes>
void visitMarkedNear(const Hierarchy& hierarchy, const Place& place, double reach, const std::uint8_t* marked,
                     void (*visit)(void*, std::uint32_t), void* context) {
  const auto near = [&](const Block& block, float(&)[kLanes]) {
    const unsigned lanes = marked[&block - hierarchy.blocks.data()];
    const PlaceInBlock p = placeIn(block, place);
    const float threshold = upwards(reach * block.inverse + p.slack);
    if (!(p.slack < 1e15f && threshold < 1e15f)) return lanes;  // squares overflow
    return lanes & ~above(boxDistances<Lanes>(block, p), Lanes::all(threshold));
  };
  const auto show = [&](const Block& block, unsigned lanes, const float*) {
    for (; lanes != 0; lanes &= lanes - 1) visit(context, block.child[__builtin_ctz(lanes)]);
    return true;
  };
  descend<false>(
      hierarchy.blocks.data(), 0, [](float) { return true; }, near, show);
}

template <class Lanes>
int findNearestEdges(const Hierarchy& hierarchy, const Place& place, std::uint32_t (&edges)[kMostNearest]) {
  double upper = 1e30, low[kMostNearest];
  int found = 0;
  PlaceInBlock p;
  const auto keepNear = [&] {
    int kept = 0;
    for (int i = 0; i < found; ++i) {
      if (low[i] > upper) continue;
      low[kept] = low[i];
      edges[kept++] = edges[i];
    }
    found = kept;
  };
  const auto lowerBound = [&](const Block& block, float distance) {
    return (static_cast<double>(distance) - p.slack) * block.scale;
  };
  const auto near = [&](const Block& block, float(&at)[kLanes]) {
    p = placeIn(block, place);
    if (!(p.slack < 1e12f)) {  // squares overflow
      upper = -__builtin_inf();
      return 0u;
    }
    const Lanes gaps = boxDistances<Lanes>(block, p);
    gaps.store(at);
    float farthest[kLanes];
    (gaps + Lanes::load(block.across) * 2.0f).store(farthest);
    float nearest = 1e30f;
    for (unsigned left = block.spanned; left != 0; left &= left - 1) {
      const float farther = farthest[__builtin_ctz(left)];
      nearest = farther < nearest ? farther : nearest;
    }
    const double least = (static_cast<double>(nearest) + p.slack) * block.scale * (1 + 0x1p-20);
    if (least < upper) upper = least;
    const unsigned lanes = lanesOf(block) & ~above(gaps, Lanes::all(upwards(upper * block.inverse + p.slack)));
    if (!block.leaf)
      for (unsigned left = lanes; left != 0; left &= left - 1) {
        const int i = __builtin_ctz(left);
        at[i] = downwards(lowerBound(block, at[i]));
      }
    return lanes;
  };
  const auto show = [&](const Block& block, unsigned lanes, const float* distance) {
    for (; lanes != 0; lanes &= lanes - 1) {
      const int i = __builtin_ctz(lanes);
      if (found == kMostNearest) keepNear();
      if (found == kMostNearest) {
        upper = -__builtin_inf();
        return false;
      }
      low[found] = lowerBound(block, distance[i]);
      edges[found++] = block.child[i];
    }
    return true;
  };
  descend<true>(
      hierarchy.blocks.data(), 0, [&](float at) { return !(at > upper); }, near, show);
  keepNear();
  return found;
}

/// Rounding as in boxDistances(); the radii, below 2, are floats.
template <class Lanes>
double depthInDiscs(const InnerDiscs& discs, const Place& place) {
  const double slack = kGapRounding * (magnitude(place.x) + magnitude(place.y) + 4) + place.error;
  if (!(slack < 1)) return -__builtin_inf();
  const Lanes dx = Lanes::load(discs.x) - static_cast<float>(place.x),
              dy = Lanes::load(discs.y) - static_cast<float>(place.y);
  return largest(Lanes::load(discs.radius) - root(dx * dx + dy * dy)) - slack;
}

}  // namespace tricover::detail::simd
