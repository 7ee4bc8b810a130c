// SPDX-License-Identifier: BSD-3-Clause
// The loop that descends one polygon's tree.
//
// Functions here that aren't templates must be always inlined: simd_avx2.cpp compiles them for AVX2.
#pragma once

#include <cstdint>

#include "hierarchy/hierarchy.h"

namespace tricover::detail {

/// Branch and bound in a tree of nodes of up to eight boxes, each with its child: a node or, in a leaf, an item. Of
/// each node that is entered, near(node, at) says which lanes may hold what is looked for, and how near they are at
/// least. If kOrdered, a node's nearest child is entered first, otherwise its last. A child is entered if keeps(its at)
/// says so by then. show(node, lanes, at) gets a leaf's lanes and returns false to end the descent.
template <bool kOrdered, class Keeps, class Near, class Show>
[[gnu::always_inline]] inline void descend(const Block* nodes, std::uint32_t root, Keeps keeps, Near near, Show show) {
  constexpr int kMost = (kLanes - 1) * kMaxDepth + 1;  // a step takes one, adds at most 8, a level below
  std::uint32_t left[kMost];                           // to be entered, the next one on top
  float left_at[kMost];
  int top = 1;
  left[0] = root;
  if (kOrdered) left_at[0] = 0;
  while (top > 0) {
    --top;
    if (kOrdered && !keeps(left_at[top])) continue;
    const Block& node = nodes[left[top]];
    float at[kLanes];
    unsigned lanes = near(node, at);
    if (lanes == 0) continue;
    if (node.leaf) {
      if (!show(node, lanes, at)) return;
      continue;
    }
    int nearest = top;
    for (; lanes != 0; lanes &= lanes - 1, ++top) {
      const int i = __builtin_ctz(lanes);
      left[top] = node.child[i];
      if (!kOrdered) continue;
      left_at[top] = at[i];
      nearest = at[i] < left_at[nearest] ? top : nearest;
    }
    if (!kOrdered) continue;
    const std::uint32_t last = left[top - 1];
    const float last_at = left_at[top - 1];
    left[top - 1] = left[nearest];
    left_at[top - 1] = left_at[nearest];
    left[nearest] = last;
    left_at[nearest] = last_at;
  }
}

}  // namespace tricover::detail
