// SPDX-License-Identifier: BSD-3-Clause
#include "hierarchy/pruned_lanes.h"

#include "hierarchy/hierarchy.h"

namespace tricover::detail {

// Blocks stand in preorder: those below one are pruned before it is asked for.
std::vector<std::uint8_t> prunedLanes(const PolygonData& polygon, const std::vector<bool>& edges) {
  const std::vector<Block>& blocks = hierarchyOf(polygon).blocks;
  std::vector<std::uint8_t> lanes(blocks.size(), 0);
  for (std::size_t k = blocks.size(); k-- > 0;) {
    const Block& block = blocks[k];
    for (unsigned i = 0; i < block.count; ++i) {
      const std::size_t child = block.child[i];
      const bool pruned = block.leaf ? edges[child] : lanes[child] == (1u << blocks[child].count) - 1;
      lanes[k] = static_cast<std::uint8_t>(lanes[k] | unsigned{pruned} << i);
    }
  }
  return lanes;
}

}  // namespace tricover::detail
