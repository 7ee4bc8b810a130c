// SPDX-License-Identifier: BSD-3-Clause
// Gaps between boxes, eight at a time. `Lanes` is eight floats side by side in some instruction set: load() and
// store() anywhere in memory, all() of one value, + - * and, where used, / of lanes and of lanes and a float, and
// absolute, root, larger, smaller, flipped (negated where the second is negative), whereAbove (the first where it is
// above the second, elsewhere something large), above (bit i: lane i of the first is above that of the second).
//
// What isn't a template over Lanes here must be always inlined: simd_avx2.cpp compiles it for AVX2.
#pragma once

#include <cassert>

#include "hierarchy/simd.h"

namespace tricover::detail::simd {

[[gnu::always_inline]] inline double magnitude(double x) { return __builtin_fabs(x); }

template <class Lanes>
[[gnu::always_inline]] inline float largest(Lanes values) {
  float v[kLanes];
  values.store(v);
  for (int step = kLanes / 2; step > 0; step /= 2)
    for (int i = 0; i < step; ++i) v[i] = v[i] > v[i + step] ? v[i] : v[i + step];
  return v[0];
}

/// Rounded upwards and downwards: converted and multiplied, it has been rounded twice.
[[gnu::always_inline]] inline float upwards(double x) { return static_cast<float>(x) * (1 + 0x1p-20f); }
[[gnu::always_inline]] inline float downwards(double x) { return static_cast<float>(x) * (1 - 0x1p-20f); }

/// UnitMap's r p in floats, by its coordinates; and where a half plane's offset goes, whose normal was turned to n.
template <class Lanes>
[[gnu::always_inline]] inline Lanes turnedX(const UnitMap& map, Lanes x, Lanes y) {
  return x * static_cast<float>(map.r00) + y * static_cast<float>(map.r01);
}
template <class Lanes>
[[gnu::always_inline]] inline Lanes turnedY(const UnitMap& map, Lanes x, Lanes y) {
  return x * static_cast<float>(map.r10) + y * static_cast<float>(map.r11);
}
template <class Lanes>
[[gnu::always_inline]] inline Lanes mappedOffset(const UnitMap& map, Lanes d, Lanes nx, Lanes ny) {
  return d * static_cast<float>(map.scale) + nx * static_cast<float>(map.tx) + ny * static_cast<float>(map.ty);
}

/// A bit for each box.
[[gnu::always_inline]] inline unsigned lanesOf(const Block& block) { return (1u << block.count) - 1; }

/// A box of one hierarchy, in its units.
struct Item {
  double x, y, ux, uy, along, across;
  std::uint32_t child;
  bool leaf, spanned;
};

constexpr std::uint32_t kRoot = 0xffffffff;

/// `degenerate_edge` is the edge that the whole hierarchy is to be taken for, if it is one
/// (PolygonData::degenerate_edge).
[[gnu::always_inline]] inline Item itemAt(const Hierarchy& hierarchy, std::uint32_t index,
                                          EdgePosition degenerate_edge) {
  if (index == kRoot) {
    const Box& box = hierarchy.root;
    const bool leaf = degenerate_edge != kNoEdge;
    return {
        box.x, box.y, box.ux, box.uy, box.along, box.across, leaf ? degenerate_edge : 0, leaf, hierarchy.root_spanned};
  }
  const Block& block = hierarchy.blocks[index / kLanes];
  const unsigned lane = index % kLanes;
  const double scale = block.scale;
  return {block.origin_x + block.x[lane] * scale,
          block.origin_y + block.y[lane] * scale,
          block.ux[lane],
          block.uy[lane],
          block.along[lane] * scale,
          block.across[lane] * scale,
          block.child[lane],
          block.leaf,
          (block.spanned >> lane & 1) != 0};
}

constexpr double kLong = 512, kKept = 64;

/// A long edge beside a small block: only its part around the block counts, which floats can tell from the block; and
/// the edge itself is known better than the float box around it. Returns the distance up to which that part stands for
/// the whole.
[[gnu::always_inline]] inline double clip(const Item& item, const PolygonData& polygon, const UnitMap& map,
                                          const Block& block, double& x, double& y, double& ux, double& uy,
                                          double& along, double& across) {
  if (item.leaf) {
    const Vec2 v = polygon.inUnits(polygon.path[item.child]), w = polygon.inUnits(polygon.path[item.child + 1]);
    const Vec2 half = 0.5 * (w - v), middle = v + half;
    const double size = map.scale * block.inverse, length = half.norm();
    x = (map.mappedX(middle.x(), middle.y()) - block.origin_x) * block.inverse;
    y = (map.mappedY(middle.x(), middle.y()) - block.origin_y) * block.inverse;
    ux = map.turnedX(half.x(), half.y()) / length;
    uy = map.turnedY(half.x(), half.y()) / length;
    along = length * size;
    across = 0;
  }
  const double at = -(x * ux + y * uy) / (ux * ux + uy * uy);
  double low = at - kKept, high = at + kKept;
  low = low < -along ? -along : low > along ? along : low;
  high = high < -along ? -along : high > along ? along : high;
  const double middle = 0.5 * (low + high);
  x += middle * ux;
  y += middle * uy;
  along = 0.5 * (high - low);
  return kKept - 4;
}

/// A box in a block's scale, from its origin. `slack` is what a gap may be too large by, and no gap is proven beyond
/// `cap`.
[[gnu::always_inline]] inline Box boxIn(const Block& block, const Item& item, const PolygonData& polygon,
                                        const UnitMap& map, float& slack, float& cap) {
  double x = (map.mappedX(item.x, item.y) - block.origin_x) * block.inverse;
  double y = (map.mappedY(item.x, item.y) - block.origin_y) * block.inverse;
  double ux = map.turnedX(item.ux, item.uy), uy = map.turnedY(item.ux, item.uy);
  const double size = map.scale * block.inverse;
  double along = item.along * size, across = item.across * size, most = 1e30;
  if (along > kLong) most = clip(item, polygon, map, block, x, y, ux, uy, along, across);
  cap = static_cast<float>(most);
  const double error = map.rounding * (magnitude(x) + magnitude(y) + along + across + 4) + map.error * block.inverse;
  slack = static_cast<float>(error);
  return {static_cast<float>(x),  static_cast<float>(y),     static_cast<float>(ux),
          static_cast<float>(uy), static_cast<float>(along), static_cast<float>(across)};
}

/// The same in registers.
template <class Lanes>
struct Boxes {
  Lanes x, y, ux, uy, along, across;
};

template <class Lanes>
[[gnu::always_inline]] inline Boxes<Lanes> boxesOf(const BoxLanes& boxes) {
  return {Lanes::load(boxes.x),  Lanes::load(boxes.y),     Lanes::load(boxes.ux),
          Lanes::load(boxes.uy), Lanes::load(boxes.along), Lanes::load(boxes.across)};
}

/// One of them.
[[gnu::always_inline]] inline Box boxAt(const BoxLanes& boxes, unsigned i) {
  return {boxes.x[i], boxes.y[i], boxes.ux[i], boxes.uy[i], boxes.along[i], boxes.across[i]};
}

/// The largest gap between the projections of a box q and of each box, over a few axes (separating axes): a lower
/// bound of their distance but for the slack; positive only if they are apart.
///
/// Sides. Four axes: along and across q, along and across the box. With c and s the cosine and sine of the
/// angle between the two, one's extents reach along c + across s along the other, and along s + across c across it.
///
/// With kAllAxes the following, too; they make a tight bound of the distance out of what tells overlap.
///
/// Diagonals. Midway between two axes at right angles the gap is the sum of theirs times sqrt(1/2): with the sides
/// every direction is within 22.5 degrees of an axis, and 0.92 (the cosine of that) of the distance is found at least.
/// Its error is sqrt(2) times that of one gap.
///
/// Centres. Along the sides of two round outlines, that are beyond each other's nearest points, no gap grows with the
/// distance; along the line of the centres it does. Its products are rounded four times and divided by what they have
/// in common, the distance of the centres. Where that is 0 the gap is NaN, which larger() drops.
template <bool kAllAxes, class Lanes>
[[gnu::always_inline]] inline Lanes gaps(const Boxes<Lanes>& box, const Box& q) {
  const Lanes ux = box.ux, uy = box.uy, along = box.along, across = box.across;
  const Lanes dx = box.x - q.x, dy = box.y - q.y;
  const Lanes c = absolute(ux * q.ux + uy * q.uy), s = absolute(ux * q.uy - uy * q.ux);
  const Lanes along_apart = absolute(dx * q.ux + dy * q.uy), across_apart = absolute(dy * q.ux - dx * q.uy);
  const Lanes box_along_apart = absolute(dx * ux + dy * uy), box_across_apart = absolute(dy * ux - dx * uy);
  const Lanes along_query = along_apart - (along * c + across * s + q.along);
  const Lanes across_query = across_apart - (along * s + across * c + q.across);
  const Lanes along_box = box_along_apart - (along + c * q.along + s * q.across);
  const Lanes across_box = box_across_apart - (across + s * q.along + c * q.across);
  const Lanes largest = larger(larger(along_query, across_query), larger(along_box, across_box));
  if constexpr (!kAllAxes) {
    return largest;
  } else {
    constexpr float kHalf = 0.70710678f;  // at most the root of 1/2 but for rounding
    const Lanes diagonal = larger(along_query + across_query, along_box + across_box) * kHalf;
    const Lanes square = dx * dx + dy * dy, extents = along * box_along_apart + across * box_across_apart +
                                                      (along_apart * q.along + across_apart * q.across);
    const Lanes between = (square - extents) / root(square);
    return larger(between, larger(largest, diagonal));
  }
}

}  // namespace tricover::detail::simd
