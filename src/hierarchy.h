// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tricover::detail {

struct PolygonData;

/// The influence hierarchy of a polygon: a binary tree over chains of consecutive edges. A node is an oriented box that
/// holds its chain (rounded outwards); grown by n it is the chain's influence area of length n. Nodes stand in
/// preorder: the left child follows its parent. Rings are split from each other first, so that below that a node is one
/// connected chain, and the depth is at most log2(rings) + log2(edges) + 2.
class Hierarchy {
 public:
  struct Node {
    double x, y;           ///< centre, in the polygon's frame
    double ux, uy;         ///< unit axis along the chain
    double along, across;  ///< half the extents
    std::uint32_t edge;    ///< leaf: the edge's position in the path
    std::uint32_t right;   ///< inner node: index of the right child; 0 in a leaf
    /// The chain reaches from end to end of the box, so no point of the box is farther than 2 * across from the chain.
    /// False above single rings.
    bool spanned;

    bool isLeaf() const { return right == 0; }
    double size() const { return along + across; }
  };

  explicit Hierarchy(const PolygonData& polygon);

  const Node& operator[](std::uint32_t index) const { return nodes_[index]; }

 private:
  struct Builder;
  std::vector<Node> nodes_;
};

}  // namespace tricover::detail
