// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "distance/edge_distance.h"
#include "hierarchy/simd.h"

namespace tricover::detail {

/// What need not be looked at because a pair of edges is as near. Let p in a and q in b be the nearest ends of that
/// pair.
///
///   A box of a is pruned if every vertex in it is p itself (at its coordinates), or certainly behind p as seen along
///   the line from p to q; a box of b likewise, beyond q.
///   So nothing of a pruned box of a is nearer to anything of a pruned box of b than p is to q,
///   and EdgeDistances::at() is no less for edges in them than for that pair, which must be pruned itself.
///
/// Equally near pairs are thus left out together, as of a corner that is given many times or that many edges share.
class PrunedBoxes {
 public:
  PrunedBoxes() = default;
  /// By these edges' positions in the paths.
  PrunedBoxes(const EdgeDistances& edges, std::size_t i, std::size_t j);

  bool any() const { return !a_.empty(); }
  PrunedPairs pairs() const { return any() ? PrunedPairs{a_.data(), b_.data()} : PrunedPairs{}; }

 private:
  std::vector<std::uint8_t> a_, b_;  ///< by blocks, bit per lane
};

}  // namespace tricover::detail
