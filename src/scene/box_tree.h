// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "hierarchy/axis_boxes.h"

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
      for (unsigned met = boxesMeeting(node.boxes, bounds); met != 0; met &= met - 1) {
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

  /// Shows every item whose box the ray meets before the fraction `most`, those that it enters first roughly first.
  /// visit returns the largest fraction that is still of interest. A box counts as entered by kEarlier earlier.
  template <typename Visit>
  void visitOnRay(const BoxRay& ray, double most, const Visit& visit) const;

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  static constexpr Bounds kNothing = {kNaN, kNaN, kNaN, kNaN};  ///< meets nothing, not even what is infinite
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  static constexpr int kLeast = 2;  ///< boxes a node, but for the root
  /// A node has two children at least, so that a tree of 2^28 items has fewer than 32 levels.
  static constexpr int kStack = 32 * (kLanes - 1) + 1;

  struct Node {
    EightBoxes boxes;             ///< beyond the count kNothing
    std::uint32_t child[kLanes];  ///< nodes, or a leaf's items
    std::uint32_t parent, lane;   ///< kNone of the root; which of the parent's boxes is around this node
    std::uint8_t count;
    bool leaf;

    Bounds at(unsigned i) const { return boxes.at(i); }
    void set(unsigned i, const Bounds& bounds) { boxes.set(i, bounds); }
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

template <typename Visit>
void BoxTree::visitOnRay(const BoxRay& ray, double most, const Visit& visit) const {
  struct Waiting {
    double least;
    std::uint32_t child;
    bool item;
  };
  if (nodes_.empty()) return;
  Waiting stack[kStack];  // of each node the first on top
  int top = 0;
  stack[top++] = {0, root_, false};
  while (top > 0) {
    const Waiting next = stack[--top];
    if (next.least > most) continue;
    if (next.item) {
      most = visit(next.child);
      continue;
    }
    const Node& node = nodes_[next.child];
    double least[kLanes];
    const int first = top;
    const unsigned used = (1u << node.count) - 1;
    for (unsigned met = boxesOnRay(node.boxes, ray, most, least) & used; met != 0; met &= met - 1) {
      const int i = __builtin_ctz(met);
      int at = top++;
      for (; at > first && stack[at - 1].least < least[i]; --at) stack[at] = stack[at - 1];
      stack[at] = {least[i], node.child[i], node.leaf};
    }
  }
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
