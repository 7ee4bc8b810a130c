// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "impact/moving_pair.h"
#include "impact/per_node.h"
#include "impact/window_cutter.h"

namespace tricover::detail {

/// The nodes of a mover as doubles fit them, where floats are too wide for narrow gaps: boxes that lie along their
/// chains to the last digits, and how far their edges are from the pivot. Each is fitted when it is first asked for;
/// all of them together cost O(n log n).
class TightNodes {
 public:
  explicit TightNodes(const Mover& mover) : mover_(mover), nodes_(mover) {}

  Node node(std::uint32_t index) {
    return nodes_.of(index, [&] { return fit(index); });
  }

 private:
  Node fit(std::uint32_t index) const;
  Vec2 at(std::uint32_t position) const { return mover_.polygon->inUnits(mover_.polygon->path[position]); }
  /// `edges` are those below the node, by their positions.
  Node fitAlong(Node node, const std::vector<std::uint32_t>& edges, const Vec2& axis) const;

  const Mover& mover_;
  PerNode<Node> nodes_;
};

/// The positions of the edges below a node.
std::vector<std::uint32_t> edgesBelow(const Mover& mover, const Node& node);

/// Whether one of two boxes is certainly farther from the other mover's pivot than that one's chain ever is, or nearer:
/// where a polygon turns about its middle, nothing but this tells that its outline stays in place.
bool partedByPivots(const Window& window, const Node& node_a, const MovingBox& a, const Node& node_b,
                    const MovingBox& b);

}  // namespace tricover::detail
