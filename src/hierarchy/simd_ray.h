// SPDX-License-Identifier: BSD-3-Clause
// A hierarchy and a ray. See simd_gaps.h for Lanes.
#pragma once

#include "hierarchy/simd_point.h"

namespace tricover::detail::simd {

/// What a ray's distance from a box may be wrong by, relative to |x| + |y| + 4 with the ray's start in the block's
/// scale. In the terms of kGapRounding: coordinates are rounded 6 times, extents 7 times, of what is at most
/// 6 (|x| + |y| + 2) + 7. The ray's length, at most twice the sum, is rounded once and subtracted: 2 * 2 more.
constexpr double kRayRounding = 0x1p-20;
/// How far along the ray a box begins at least: one rounding more, and slack enough for that if it is taken twice.
static_assert(kRayRounding >= (7 + 2 * 2) * kFloatRoundoff && 6 * 2 + 7 * 1 <= 7 * 4);

/// The boxes that may hold the ray's begin.
template <class Lanes>
unsigned boxesAround(const Ray& ray, const Block& block) {
  const PlaceInBlock p = placeIn(block, {ray.x, ray.y, ray.error});
  if (!(p.slack < 1e15f)) return lanesOf(block);  // squares overflow
  return lanesOf(block) & ~above(boxDistances<Lanes>(block, p), Lanes::all(p.slack));
}

/// The boxes that the ray may meet, and how far along it they begin at least.
template <class Lanes>
unsigned boxesOn(const Ray& ray, const Block& block, float (&at)[kLanes]) {
  const float dx = static_cast<float>(ray.dx), dy = static_cast<float>(ray.dy);
  const double px = (ray.x - block.origin_x) * block.inverse, py = (ray.y - block.origin_y) * block.inverse;
  const double sum = magnitude(px) + magnitude(py) + 4, length = ray.length * block.inverse;
  const double slack = kRayRounding * sum + ray.error * block.inverse;
  const float x = static_cast<float>(px), y = static_cast<float>(py), room = static_cast<float>(slack);
  const float end = static_cast<float>(length < 2 * sum ? length : 2 * sum);
  if (!(room < 1e30f)) {
    for (float& entry : at) entry = 0;
    return lanesOf(block);
  }
  const Boxes<Lanes> box = boxesOf<Lanes>(block);
  const Lanes ex = box.x - x, ey = box.y - y;
  const Lanes c = absolute(box.ux * dx + box.uy * dy), s = absolute(box.ux * dy - box.uy * dx);
  const Lanes beside = absolute(ey * dx - ex * dy) - (box.along * s + box.across * c);
  const Lanes ahead = ex * dx + ey * dy, reach = box.along * c + box.across * s;
  const Lanes behind = (Lanes::all(0) - ahead) - reach, after = (ahead - reach) - end;
  ((ahead - reach - 2 * room) * block.scale).store(at);
  return lanesOf(block) & ~above(larger(beside, larger(behind, after)), Lanes::all(room));
}

template <class Lanes>
void visitEdgesOnRay(const Hierarchy& hierarchy, const Ray& ray, bool (*visit)(void*, std::uint32_t), void* context) {
  descend<true>(
      hierarchy.blocks.data(), 0, [&](float at) { return !(at > ray.length); },
      [&](const Block& block, float(&at)[kLanes]) {
        const unsigned lanes = boxesOn<Lanes>(ray, block, at);
        // A box that isn't around a chain is around whole rings.
        const bool leaves_out = ray.for_winding && (lanes & ~block.spanned) != 0;
        return leaves_out ? lanes & (block.spanned | boxesAround<Lanes>(ray, block)) : lanes;
      },
      [&](const Block& block, unsigned lanes, const float*) {
        for (; lanes != 0; lanes &= lanes - 1)
          if (!visit(context, block.child[__builtin_ctz(lanes)])) return false;
        return true;
      });
}

}  // namespace tricover::detail::simd
