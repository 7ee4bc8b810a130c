// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "hierarchy/axis_boxes.h"

namespace tricover::detail {

/// A tree of boxes that are added, moved and removed: an R-tree (Guttman 1984) of eight boxes a node, which SIMD lanes
/// compare at once. Each box belongs to an item; the caller numbers the items.
class BoxTree {
 public:
  struct Entry {
    Bounds bounds;
    std::uint32_t child;  ///< an item, or a node
  };

  /// Replaces all items by these and packs them, so that each node is around boxes that lie together. Throws before
  /// anything has changed.
  void pack(const std::vector<Entry>& entries);
  /// Adds an item that isn't in the tree. Throws before anything has changed.
  void insert(std::uint32_t item, const Bounds& bounds);
  void remove(std::uint32_t item);
  /// Reserves memory for the next move(), which doesn't throw then.
  void prepareMove() {
    if (free_.size() < kLevels) reserveFor(0);
  }
  /// Changes the box of an item.
  void move(std::uint32_t item, const Bounds& bounds);
  bool holds(std::uint32_t item) const { return item < places_.size() && places_[item] != kNone; }
  /// Returns how many boxes have been inserted or changed nodes since the tree was packed. They make it worse.
  std::size_t changes() const { return changes_; }
  Bounds boundsOf(std::uint32_t item) const { return nodes_[places_[item] / kLanes].at(places_[item] % kLanes); }

  /// Calls visit(item) for every item whose box meets `bounds`, until it returns false.
  template <typename Visit>
  void visit(const Bounds& bounds, const Visit& visit) const {
    if (root_ == kNone) return;
    std::uint32_t stack[kStack];
    int top = 0;
    stack[top++] = root_;
    while (top > 0) {
      const Branch& node = nodes_[stack[--top]];
      unsigned met = boxesMeeting(node, bounds);
      if (!node.leaf) {
        for (; met != 0; met &= met - 1) stack[top++] = node.child[__builtin_ctz(met)];
        continue;
      }
      // The branch predictor foresees the only item of a leaf, so that its visit doesn't wait for the comparison.
      for (; met != 0; met &= met - 1)
        if (!visit(node.child[__builtin_expect(node.count == 1, 1) ? 0 : __builtin_ctz(met)])) return;
    }
  }

  /// Calls visit(item) for every item whose box is no farther from `bounds` than `most`, near nodes and items first.
  /// visit returns the largest distance that is still of interest.
  template <typename Visit>
  void visitNear(const Bounds& bounds, double most, const Visit& visit) const {
    visitInOrder(
        gapSquareAbove(most),
        [&](const EightBoxes& boxes, double limit, double* at) { return boxesNear(boxes, bounds, limit, at); },
        [&](std::uint32_t item) { return gapSquareAbove(visit(item)); });
  }

  /// Calls visit(item) for every item whose box the ray enters before the fraction `most`, the first nodes and items
  /// first. visit returns the largest fraction that is still of interest. A box counts as entered by kEarlier earlier.
  template <typename Visit>
  void visitOnRay(const BoxRay& ray, double most, const Visit& visit) const {
    visitInOrder(
        most, [&](const EightBoxes& boxes, double limit, double* at) { return boxesOnRay(boxes, ray, limit, at); },
        visit);
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  static constexpr Bounds kNothing = {kNaN, kNaN, kNaN, kNaN};  ///< meets nothing, not even what is infinite
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  /// A split leaves at most six boxes in a node, so that the node takes three more before its next split. Hence fewer
  /// than 3^31 insertions make fewer levels than this.
  static constexpr int kLevels = 32;
  static constexpr int kStack = kLevels * (kLanes - 1) + 1;

  /// Boxes beyond the count are kNothing.
  struct Branch : EightBoxes {
    std::uint32_t child[kLanes];  ///< nodes, or a leaf's items
    std::uint32_t parent, lane;   ///< kNone for the root; the index of this node among the parent's boxes
    std::uint8_t count;
    bool leaf;

    Bounds all() const;
  };

  /// The middle of an entry's box.
  struct Middle {
    double x, y;
    std::uint32_t entry;
  };

  /// How near a box is at least, and its lane, as one number, so that the least one tells the first box without a
  /// branch that depends on them all: doubles that aren't negative are in the order of their bits, of which the last
  /// three are the lane, so that it comes a little earlier.
  static std::int64_t keyOf(double least, std::int64_t lane) {
    std::int64_t bits;
    least += 0;  // -0, of a ray that begins on an outline, is 0
    std::memcpy(&bits, &least, sizeof bits);
    return (bits & -std::int64_t{kLanes}) | lane;
  }

  /// Calls visit(item), which returns the new `most`, the nearest node and item first: descend() by keys. near(boxes,
  /// most, at) says which boxes of a node may be within `most`, and how near they are at least.
  template <typename Near, typename Visit>
  void visitInOrder(double most, const Near& near, const Visit& visit) const;

  std::uint32_t packed(Middle* first, std::size_t count, int height, const std::vector<Entry>& entries);
  void packGroups(std::uint32_t node, Middle* first, std::size_t count, std::size_t groups, int height,
                  const std::vector<Entry>& entries);

  std::uint32_t newNode(bool leaf);
  void put(std::uint32_t index, unsigned lane, const Entry& entry);
  std::uint32_t leafFor(const Bounds& bounds);
  void addTo(std::uint32_t index, const Entry& entry);
  void split(std::uint32_t index, const Entry& entry);
  void takeFrom(std::uint32_t index, unsigned lane);
  void tighten(std::uint32_t index);
  void reserveNodes(std::size_t more);
  void reserveFor(std::uint32_t item);

  std::vector<Branch> nodes_;
  std::vector<std::uint32_t> free_;
  std::vector<std::uint32_t> places_;  ///< node and lane of each item, as one number
  std::uint32_t root_ = kNone;
  std::size_t changes_ = 0;
};

template <typename Near, typename Visit>
void BoxTree::visitInOrder(double most, const Near& near, const Visit& visit) const {
  struct Level {
    const Branch* node;
    unsigned left;  ///< lanes that haven't been entered
    std::int64_t keys[kLanes];
  };
  if (root_ == kNone) return;
  constexpr std::int64_t kEntered = std::numeric_limits<std::int64_t>::max();
  Level levels[kLevels];
  std::int64_t last = keyOf(most, kLanes - 1);
  const auto open = [&](Level& level, std::uint32_t index) {
    double at[kLanes];
    level.node = &nodes_[index];
    level.left = near(*level.node, most, at);
    for (int i = 0; i < kLanes; ++i) level.keys[i] = level.left >> i & 1 ? keyOf(at[i], i) : kEntered;
  };
  Level* level = levels;
  open(*level, root_);
  for (;;) {
    const unsigned left = level->left;
    if (left == 0) {
      if (level-- == levels) return;
      continue;
    }
    // The branch predictor foresees a single lane. The first of several is found without branches.
    const std::int64_t* keys = level->keys;
    const bool alone = (left & (left - 1)) == 0;
    const std::int64_t first = alone ? keys[__builtin_ctz(left)]
                                     : std::min(std::min(std::min(keys[0], keys[1]), std::min(keys[2], keys[3])),
                                                std::min(std::min(keys[4], keys[5]), std::min(keys[6], keys[7])));
    if (first > last) {
      level->left = 0;
      continue;
    }
    const unsigned lane = static_cast<unsigned>(first) % kLanes;
    level->left = left & ~(1u << lane);
    level->keys[lane] = kEntered;
    const std::uint32_t child = level->node->child[lane];
    if (!level->node->leaf) {
      open(*++level, child);
      continue;
    }
    most = visit(child);
    last = keyOf(most, kLanes - 1);
  }
}

}  // namespace tricover::detail
