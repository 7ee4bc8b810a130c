// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "hierarchy/hierarchy.h"
#include "numbers/double2.h"
#include "scene/bounds.h"

namespace tricover::detail {

/// A tree of boxes that come, move and go: an R-tree (Guttman 1984) of eight boxes a node, which are asked side by
/// side. Each box is an item's; items are numbered by its user.
class BoxTree {
 public:
  /// No item is in the tree twice. Throws before anything has changed.
  void insert(std::uint32_t item, const Bounds& bounds);
  void remove(std::uint32_t item);
  /// Another box for an item.
  void move(std::uint32_t item, const Bounds& bounds);
  Bounds boundsOf(std::uint32_t item) const { return nodes_[places_[item] / kLanes].at(places_[item] % kLanes); }

  /// Calls visit(item) for every item whose box meets `bounds`, until it returns false. Returns whether it never did.
  template <typename Visit>
  bool visit(const Bounds& bounds, const Visit& visit) const {
    if (nodes_.empty()) return true;
    std::uint32_t stack[kStack];
    int top = 0;
    stack[top++] = root_;
    while (top > 0) {
      const Node& node = nodes_[stack[--top]];
      for (unsigned met = node.meeting(bounds); met != 0; met &= met - 1) {
        const std::uint32_t child = node.child[__builtin_ctz(met)];
        if (!node.leaf)
          stack[top++] = child;
        else if (!visit(child))
          return false;
      }
    }
    return true;
  }

  /// Shows every item, those whose boxes have a small bound first: bound(Bounds) is at most what visit(item) is about,
  /// NaN never. visit returns the largest bound that is still of interest.
  template <typename Bound, typename Visit>
  void visitInOrder(double most, const Bound& bound, const Visit& visit) const;

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  static constexpr Bounds kNothing = {kNaN, kNaN, kNaN, kNaN};  ///< meets nothing, not even what is infinite
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  static constexpr int kLeast = 2;  ///< boxes a node, but for the root
  /// A node has two children at least, so that a tree of 2^28 items has fewer than 32 levels.
  static constexpr int kStack = 32 * (kLanes - 1) + 1;

  struct alignas(64) Node {
    double min_x[kLanes], min_y[kLanes], max_x[kLanes], max_y[kLanes];
    std::uint32_t child[kLanes];  ///< nodes, or a leaf's items
    std::uint32_t parent, lane;   ///< kNone of the root; which of the parent's boxes is around this node
    std::uint8_t count;
    bool leaf;

    /// Bit per lane. Lanes beyond the count hold kNothing.
    unsigned meeting(const Bounds& bounds) const;
    Bounds at(unsigned i) const { return {min_x[i], min_y[i], max_x[i], max_y[i]}; }
    void set(unsigned i, const Bounds& bounds) {
      min_x[i] = bounds.min_x, min_y[i] = bounds.min_y, max_x[i] = bounds.max_x, max_y[i] = bounds.max_y;
    }
    Bounds all() const;
  };

  struct Entry {
    Bounds bounds;
    std::uint32_t child;
  };

  std::uint32_t newNode(bool leaf);
  void freeNode(std::uint32_t index);
  void put(std::uint32_t index, unsigned lane, const Entry& entry);
  std::uint32_t leafFor(const Bounds& bounds);
  void addTo(std::uint32_t index, const Entry& entry);
  void split(std::uint32_t index, const Entry& entry);
  void takeFrom(std::uint32_t index, unsigned lane);
  void tighten(std::uint32_t index);
  void reserveFor(std::uint32_t item);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> free_;
  std::vector<std::uint32_t> places_;  ///< node and lane of each item, as one number
  std::uint32_t root_ = kNone;
};

inline unsigned BoxTree::Node::meeting(const Bounds& bounds) const {
  unsigned bits = 0;
  for (int i = 0; i < kLanes; i += 2) {
    const Bits2 met = (load2(min_x + i) <= bounds.max_x - Double2{}) & (bounds.min_x - Double2{} <= load2(max_x + i)) &
                      (load2(min_y + i) <= bounds.max_y - Double2{}) & (bounds.min_y - Double2{} <= load2(max_y + i));
#ifdef __SSE2__
    bits |= static_cast<unsigned>(__builtin_ia32_movmskpd((Double2)met)) << i;
#else
    bits |= ((met[0] != 0 ? 1u : 0u) | (met[1] != 0 ? 2u : 0u)) << i;
#endif
  }
  return bits;
}

template <typename Bound, typename Visit>
void BoxTree::visitInOrder(double most, const Bound& bound, const Visit& visit) const {
  struct Waiting {
    double bound;
    std::uint32_t child;
    bool node;
    bool operator<(const Waiting& other) const { return bound > other.bound; }  // for a heap, least first
  };
  if (nodes_.empty()) return;
  std::vector<Waiting> heap{{-kInfinity, root_, true}};
  while (!heap.empty() && heap.front().bound <= most) {
    const Waiting next = heap.front();
    std::pop_heap(heap.begin(), heap.end());
    heap.pop_back();
    if (!next.node) {
      most = visit(next.child);
      continue;
    }
    const Node& node = nodes_[next.child];
    for (unsigned i = 0; i < node.count; ++i) {
      const double least = bound(node.at(i));
      if (!(least <= most)) continue;
      heap.push_back({least, node.child[i], !node.leaf});
      std::push_heap(heap.begin(), heap.end());
    }
  }
}

}  // namespace tricover::detail
