// SPDX-License-Identifier: BSD-3-Clause
// One hierarchy descended. See simd_gaps.h for Lanes.
#pragma once

#include "hierarchy/simd_gaps.h"

namespace tricover::detail::simd {

/// The blocks that are left to enter, the nearest on top.
struct NearBlocks {
  static constexpr int kMost = (kLanes - 1) * kMaxDepth + 1;  // a step takes one, adds at most 8, a level below
  std::uint32_t block[kMost];
  float at[kMost];
  int top = 0;

  [[gnu::always_inline]] void add(std::uint32_t index, float distance) {
    block[top] = index;
    at[top++] = distance;
  }

  /// Puts the nearest of those from `first` on on top.
  [[gnu::always_inline]] void raiseNearest(int first) {
    int nearest = first;
    for (int i = first + 1; i < top; ++i) nearest = at[i] < at[nearest] ? i : nearest;
    const std::uint32_t last = block[top - 1];
    const float last_at = at[top - 1];
    block[top - 1] = block[nearest];
    at[top - 1] = at[nearest];
    block[nearest] = last;
    at[nearest] = last_at;
  }
};

/// Branch and bound. Of each block that is entered, near(block, at) says which lanes may hold what is looked for, and
/// how near they are at least: of a block's children the nearest is entered first if kOrdered, otherwise the last. A
/// child is entered if keeps(its at) says so by then. A leaf's lanes are edges: show(block, lanes, at) returns false to
/// end the descent.
template <bool kOrdered, class Keeps, class Near, class Show>
void descendOne(const Hierarchy& hierarchy, Keeps keeps, Near near, Show show) {
  const Block* all = hierarchy.blocks.data();
  NearBlocks blocks;
  blocks.add(0, 0);
  while (blocks.top > 0) {
    if (!keeps(blocks.at[--blocks.top])) continue;
    const Block& block = all[blocks.block[blocks.top]];
    float at[kLanes];
    unsigned lanes = near(block, at);
    if (lanes == 0) continue;
    if (block.leaf) {
      if (!show(block, lanes, at)) return;
      continue;
    }
    const int first = blocks.top;
    for (; lanes != 0; lanes &= lanes - 1) {
      const int i = __builtin_ctz(lanes);
      blocks.block[blocks.top] = block.child[i];
      if (kOrdered) blocks.at[blocks.top] = at[i];
      ++blocks.top;
    }
    if (kOrdered) blocks.raiseNearest(first);
  }
}

}  // namespace tricover::detail::simd
